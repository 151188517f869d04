// SPDX-License-Identifier: MIT
// Has the driver of the current EGL device compile and link programs, and prints what its compiler
// says of them. `crevice cost` runs it on Mesa's drivers for phones;
// tools/scripts/mobile_compilers.sh builds it.
//
// Standard input, for each program:
//   program NAME VERTEX_BYTES FRAGMENT_BYTES\n, then the two texts
// Output, stdout and stderr in one so that their order stays:
//   device RENDERER, then version VERSION;
//   program NAME, then the compiler's own lines: its KHR_debug messages, and what it prints by
//   itself;
//   refused LINE, for each line of the log of what does not compile or link;
//   end
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static int fail(const char* what)
{
    printf("failed %s (EGL error 0x%x)\n", what, eglGetError());
    return 1;
}

static void onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                      const GLchar* text, const void* user)
{
    (void)source, (void)type, (void)id, (void)severity, (void)length, (void)user;
    printf("%s\n", text);
}

// Reads a text of `size` bytes from standard input; null where there are fewer.
static char* readText(size_t size)
{
    char* text = malloc(size + 1);
    if (!text || fread(text, 1, size, stdin) != size) return NULL;
    text[size] = 0;
    return text;
}

static void printRefusal(char* log)
{
    for (char* line = log; *line;) {
        char* end = line;
        while (*end && *end != '\n') ++end;
        printf("refused %.*s\n", (int)(end - line), line);
        line = *end ? end + 1 : end;
    }
    if (!*log) printf("refused without a word\n");
}

static GLuint compileStage(GLenum kind, const char* text)
{
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &text, NULL);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    char log[4096] = "";
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    if (!done) printRefusal(log);
    return done ? shader : 0;
}

static void compileProgram(const char* vertex_text, const char* fragment_text)
{
    const GLuint vertex = compileStage(GL_VERTEX_SHADER, vertex_text);
    const GLuint fragment = compileStage(GL_FRAGMENT_SHADER, fragment_text);
    if (!vertex || !fragment) return;
    const GLuint program = glCreateProgram();
    glAttachShader(program, vertex);
    glAttachShader(program, fragment);
    glLinkProgram(program);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    char log[4096] = "";
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    if (!done) printRefusal(log);
}

// Makes a context without a surface current. 0 when it is.
static int openContext(void)
{
    const EGLDisplay display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (!eglInitialize(display, NULL, NULL)) return fail("no EGL display");
    eglBindAPI(EGL_OPENGL_ES_API);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
    const EGLContext context =
        eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (!context) return fail("no OpenGL ES 3 context");
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        return fail("the context is not current");
    const PFNGLDEBUGMESSAGECALLBACKPROC listen =
        (PFNGLDEBUGMESSAGECALLBACKPROC)eglGetProcAddress("glDebugMessageCallbackKHR");
    if (!listen) return fail("no GL_KHR_debug, by which compilers tell their figures");
    // Not GL_DEBUG_OUTPUT_SYNCHRONOUS: Mesa's threaded contexts then drop the messages.
    glEnable(GL_DEBUG_OUTPUT);
    listen(onMessage, NULL);
    return 0;
}

int main(void)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    dup2(STDOUT_FILENO, STDERR_FILENO);
    if (openContext() != 0) return 1;
    printf("device %s\n", (const char*)glGetString(GL_RENDERER));
    printf("version %s\n", (const char*)glGetString(GL_VERSION));
    char name[256];
    size_t vertex_size, fragment_size;
    while (scanf("program %255s %zu %zu", name, &vertex_size, &fragment_size) == 3 &&
           getchar() == '\n') {
        char* vertex = readText(vertex_size);
        char* fragment = readText(fragment_size);
        if (!vertex || !fragment) return fail("the input ends within a program");
        printf("program %s\n", name);
        compileProgram(vertex, fragment);
        free(vertex);
        free(fragment);
    }
    printf("end\n");
    return 0;
}
