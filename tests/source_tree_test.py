#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The source tree against its rules: who includes whom, where GL is named, who prints, licences, what is cited. Each
rule is first shown texts that break it.
   source_tree_test.py SOURCE"""
import glob
import os
import re
import subprocess
import sys

MAY_INCLUDE = {
    'core': ['core'],
    'backends': ['backends', 'core'],
    'effects': ['effects', 'core'],
    'effects/api/c': ['effects', 'core', 'backends'],
    'tools': ['tools', 'core', 'backends', 'effects'],
    'tests': ['tests', 'tools', 'core', 'backends', 'effects'],
}
# The layers of a library from the bottom up: a file may include its own layer and those before it.
LAYERS = {
    'core': 'base json glsl gpu frame sampling config plan bake compile run renderer'.split(),
    'backends': 'gl context recording'.split(),
    'tools': 'render/image bake commands/cli render/glsl show/schema show/plan render/scene measure/reference render/device render '
             'measure/cost measure/motion measure measure/bench measure/stress measure/matrix show/report show/view show/page commands '
             'examples'.split(),
}
TOKENS = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)


class Source:
    def __init__(self, path, text):
        self.path, self.text = path, text
        self.folders = path.split('/')
        self.example = path.startswith('tools/examples/')
        self.cpp = path.endswith(('.h', '.cpp'))
        self.code = self.words = ''
        if self.cpp:  # without comments, and of words without what strings say
            self.code = TOKENS.sub(lambda token: '' if token[0][0] == '/' else token[0], text)
            self.words = TOKENS.sub('', text)
        self.includes = re.findall(r'^\s*#\s*include (["<][^">]+)', self.code, re.M)


def read_tree(root):
    found = {}
    for top in 'core', 'backends', 'effects', 'configs', 'tools', 'tests':
        for folder, _, names in os.walk(os.path.join(root, top)):
            for name in names:
                path = os.path.relpath(os.path.join(folder, name), root)
                with open(os.path.join(folder, name), encoding='latin-1') as file:
                    found[path] = Source(path, file.read())
    return found


tree = read_tree(sys.argv[1])
headers = {'<crevice/' + path.rsplit('/', 1)[1]: path for path in tree if '/include/crevice/' in path}
# A source's own header comes first.
homes = {(each.folders[0], each.includes[0]): each for each in tree.values()
         if each.path.endswith('.cpp') and each.includes}
configs = [os.path.basename(path)[:-5] for path in tree if re.match('configs/.*json', path)]


def target(include):
    """The path that an include names; empty for those of others."""
    return headers.get(include) or (include[1:] if include[0] == '"' else '')


def included(source):
    return [tree[target(each)] for each in source.includes if target(each) in tree]


def folder_layer(source):
    """The layer whose folder holds a source, itself or in folders of no layer; empty where none does."""
    parts = source.folders[1:-1]
    while parts and '/'.join(parts) not in LAYERS[source.folders[0]]:
        parts = parts[:-1]
    return '/'.join(parts)


def layer(source):
    """A public header belongs to the layer of its source; without one, to the highest that it includes."""
    if source.folders[1] != 'include':
        return LAYERS[source.folders[0]].index(folder_layer(source))
    home = homes.get((source.folders[0], '<crevice/' + source.folders[-1]))
    if home:
        return layer(home)
    return max([layer(each) for each in included(source) if each.folders[0] == source.folders[0]], default=0)


def sideways(source):
    library = 'effects/api/c' if source.path.startswith('effects/api/c/') else source.folders[0]
    paths = [target(each) for each in source.includes]
    return [path for path in paths if path and path.split('/')[0] not in MAY_INCLUDE[library]]


def climbing(source):
    return [each.path for each in included(source)
            if each.folders[0] == source.folders[0] and layer(each) > layer(source)]


def config_behind_plan(source):
    """Files of the config language and of JSON that what runs a plan includes, through others too."""
    seen, rest = set(), [source] if source.folders[1] in ('run', 'gpu') else []
    while rest:
        new = [each for each in included(rest.pop()) if each.path not in seen]
        seen.update(each.path for each in new)
        rest += new
    return [path for path in seen if LAYERS['core'][layer(tree[path])] in ('config', 'json')]


def private(source):
    beside = os.path.dirname(source.path) + '/'
    return source.example and [each for each in source.includes if each[0] == '"' and beside + each[1:] not in tree and
                               not each.startswith('"tools/examples/')]


def unlicensed(source):
    kinds = r'\.(h|c|cpp|cmake|sh|py|frag|vert|glsl|comp|in)$|/CMakeLists\.txt$'
    return re.search(kinds, source.path) and 'SPDX-License-Identifier: MIT' not in source.text[:60]


def words(pattern):
    return lambda source: re.findall(pattern, source.words)


FLOAT_FORMAT = r'"[^"\n]*%[-+#0-9.*]*l?[aAeEfFgG][^"\n]*"'
NO_EXAMPLE = 'tools/examples/'
# What holds, where, what finds the contrary, where it does not hold, and texts that break it.
RULES = [
    ('includes point downwards', 'core backends effects tools tests', sideways, ('tests/installed/', NO_EXAMPLE),
     [('core/config/x.h', '#include "backends/gl/device.h"\n'), ('core/plan/x.h', '#include "plan.h"\n'),
      ('effects/x.cpp', '#include <crevice/gl_device.h>\n'), ('backends/gl/x.cpp', '#include "effects/effect.h"\n'),
      ('effects/api/c/x.cpp', '#include "tools/render/image/image_file.h"\n')]),
    ('layers include those before them', 'core backends tools', lambda source: source.cpp and climbing(source), (),
     [('core/config/x.cpp', '#include "core/compile/steps.h"\n'), ('core/base/x.h', '#include <crevice/document.h>\n'),
      ('core/gpu/x.cpp', '#include <crevice/config.h>\n')]),
    ('what runs a plan knows no config and no JSON', 'core', config_behind_plan, (),
     [('core/run/x.cpp', '#include <crevice/renderer.h>\n')]),
    ("graphics headers are the backends'", 'core effects tools tests',
     lambda source: [each for each in source.includes if re.match(r'.(GL\w*|EGL|KHR)/', each)], NO_EXAMPLE,
     [('tests/x.cpp', '#include <GLES3/gl3.h>\n'), ('core/x.h', '#include <EGL/egl.h>\n')]),
    ('nothing of GL is named outside backends', 'core effects tools',
     words(r'\b(?:(?:gl|egl|OSMesa|E?GL_)[A-Z]\w+|GL(?:u?int|enum|float|sizei|boolean|bitfield)|EGL[DC]\w+)\b'),
     NO_EXAMPLE, [('core/x.cpp', 'glClear(mask);'), ('core/x.cpp', 'int a = GL_RGBA8;'), ('core/x.h', 'GLuint name;')]),
    ('numbers are read and written by core/base/text.h, which knows no locale', 'core backends effects tools',
     lambda source: re.findall(r'\b(?:strto(?:f|d|ld)|atof|sto(?:f|d|ld)|set(?:locale|precision))\s*\(|'
                               r'\b[io]?stringstream\b|' + FLOAT_FORMAT, source.code), ('core/base/text.cpp', NO_EXAMPLE),
     [('core/x.cpp', 'snprintf(text, 9, "vec2(%.3e", x);'), ('core/x.cpp', 'std::stof(text)'),
      ('core/x.cpp', 'sscanf(text, "%d %lf", &n, &x);'), ('core/x.cpp', 'std::ostringstream out;')]),
    ('text is printed by tools/commands/cli/output.h, which keeps control characters off the terminal',
     'core backends effects tools',
     words(r'\b(?:v?f?printf|f?puts|f?putc|putchar|cout|cerr|clog|stdout|stderr)\b'), ('tools/commands/cli/output.', NO_EXAMPLE),
     [('tools/x.cpp', 'std::printf(x);'), ('tools/x.cpp', 'std::cout << x;')]),
    ('files are opened where pipes, devices and endless files are refused', 'core backends effects tools',
     words(r'\b(?:[io]?fstream|fopen|freopen|fdopen)\b'),
     ('core/base/files.cpp', 'tools/render/image/image_file.cpp', 'tools/measure/line_file.cpp'),
     [('tools/x.cpp', 'std::ifstream file(path);')]),
    ('no library names a config', 'core backends effects',
     lambda source: [each for each in configs if '"%s"' % each in source.code or each + '.json' in source.code], (),
     [('core/x.cpp', 'find("gtao")'), ('core/x.cpp', 'find("configs/gtao.json")')]),
    ('examples include public headers and one another alone', 'tools', private, (),
     [('tools/examples/a.cpp', '#include "core/base/text.h"\n')]),
    ('examples have at most 120 lines', 'tools', lambda source: source.example and source.text.count('\n') > 120, (),
     [('tools/examples/a.cpp', 121 * '\n')]),
    ('files have at most 600 lines', 'core backends effects tools tests',
     lambda source: source.cpp and source.text.count('\n') > 600, 'effects/api/c/include/',
     [('core/x.cpp', 601 * '\n')]),
    ('functions of the libraries have at most 40 lines', 'core backends effects',
     lambda source: [body.count('\n') for body in re.findall(r'^\{\n(.*?)^\}', source.code, re.M | re.S)
                     if body.count('\n') > 40], 'backends/gl/caps.cpp',
     [('core/x.cpp', 'int f()\n{' + 42 * '\n' + '}')]),
    ('beside a depth a colour has four channels: on fewer Mesa 22.3 for Mali crashes', 'effects configs',
     lambda source: 'gl_FragDepth' in source.text and
     re.search(r'^(?:layout[^;]*\) )?out (?:\w+ )?(?:float|vec[23]) \w+;', source.text, re.M), (),
     [('effects/x.frag', 'layout(location = 0) out float ao;\nvoid main() { gl_FragDepth = ao = 1.0; }')]),
    ('sources have the licence line', 'core backends effects configs tools tests', unlicensed, (),
     [('core/x.cpp', '#include <vector>\n'), ('tests/CMakeLists.txt', '# tests\n')]),
]

# --- citations: "Author Year" of a line in SOURCES ---

SOURCES = 'docs/reference/sources.md'
NAME, YEAR = r"(?:de )?[A-Z][\w'-]+", r'(?:(?:1[789]|20)\d\d\b|n\.d\.)'
# Authors and a year; in shaders and pages what stands in brackets and begins with a name.
CITED = re.compile(r'(?<!\w)((?:%s, )*%s(?: et al\.)?) (%s)' % (NAME, NAME, YEAR))
BRACKETED = re.compile(r'\[(?=(?:de )?[A-Z][a-z])([^][]*)\](?![(:])')
EPONYMS = 'Bayer Blinn Lambert Phong'.split()  # which name what they found, too
MONTHS = 'January February March April May June July August September October November December'.split()


def sources_of(page):
    """How each row is cited: all of one or two authors, of more the first; and the names of all authors."""
    rows = re.findall(r'^\* ([^:]*) (%s):' % YEAR, page, re.M)
    return ([(authors if authors.count(',') < 2 else authors.split(',')[0] + ' et al.') + ' ' + year
             for authors, year in rows],
            {name for authors, _ in rows for name in authors.split(', ')
             if name not in EPONYMS and not name.isupper()})


def citations(path, text, names):
    """The citations of a text, what looks like one, and names without a year."""
    prose = re.sub(r'`[^`\n]*`', '', re.sub(r'\s+', ' ', re.sub(r'\n *//+', '\n', text)))
    found = [' '.join(each) for each in CITED.findall(prose) if each[0] not in MONTHS]
    if path.endswith(('.md', '.frag', '.vert', '.glsl')):
        found += [each for each in BRACKETED.findall(prose)
                  if not CITED.match(each) or re.search(r'(?:\d|d\.), "', each)]
    return found + [each for each in re.findall(r"[A-Z][\w'-]+", CITED.sub('', prose)) if each in names]


def uncited(page, texts):
    """What is cited without a row, and the rows that nothing cites."""
    sources, names = sources_of(page)
    found = [(path, each) for path, text in texts for each in citations(path, text, names)]
    return ([(path, 'has no row', each) for path, each in found if each not in sources] +
            [(SOURCES, 'nothing cites', each) for each in sources if each not in [cite for _, cite in found]])


failures = []
ROW = '* Li, de Wit 1999: [T](http://a)\n'
for text in ('[Li, de Wit 1999; Wu 2020]', '// [Li, de Wit 1999] as Wu\n// et al. 2020 has it',
             '[Li, de Wit 1999] [Wu, "T"]', '[Li 1999]', '[Li, de Wit 1999, "T"]', '[Li, de Wit 1999] Li says so', 'nobody'):
    if not uncited(ROW, [('x.glsl', text)]):
        failures.append('no citation is missed in %r' % text)
failures += ['a citation is missed in %r: %s' % (text, uncited(ROW, [('x.glsl', text)]))
             for text in ('// [Li,\n// de Wit 1999 - the tile] in November 2026',) if uncited(ROW, [('x.glsl', text)])]
cited_in = [(path, source.text) for path, source in tree.items()
            if path.split('/')[0] in ('core', 'effects', 'configs', 'tools') and
            path.endswith(('.h', '.cpp', '.glsl', '.frag', '.vert', '.json', '.md'))]
with open(os.path.join(sys.argv[1], SOURCES), encoding='utf-8') as file:
    page = file.read()
for path in [path for below in ('*.md', 'docs/*.md', 'docs/*/*.md') for path in glob.glob(os.path.join(sys.argv[1], below))]:
    if not path.endswith(SOURCES):
        with open(path, encoding='utf-8') as file:
            cited_in.append((os.path.relpath(path, sys.argv[1]), file.read()))
failures += ['%s: in %s %s: %s' % (path, SOURCES, *said) for path, *said in uncited(page, cited_in)]

for says, folders, broken_by, but_not, planted in RULES:
    failures += ['the rule fails for no text: %s, %r' % (says, text) for path, text in planted
                 if not broken_by(Source(path, text))]
    for source in tree.values():
        found = source.folders[0] in folders.split() and not source.path.startswith(but_not) and broken_by(source)
        if found:
            failures.append('%s: %s, not so by %s' % (source.path, says, found))

counts = {}
for path in tree:
    if not path.startswith(('configs/', 'tests/data/', 'tests/fuzz/seeds/')):
        counts.setdefault(os.path.dirname(path), []).append(path)
failures += ['%s has %d files' % (folder, len(paths)) for folder, paths in counts.items() if len(paths) > 25]
for library, layers in LAYERS.items():
    there = {folder_layer(each) or each.path for each in tree.values()
             if each.folders[0] == library and each.folders[1] != 'include' and each.cpp}
    failures += ['%s/%s is in no layer, or a layer without files' % (library, each) for each in there ^ set(layers)]

# Faults that are planted follow what they are planted in.
for table, column, base in ('code.txt', 1, ''), ('shaders.txt', 2, 'effects/'):
    for fault in open(os.path.join(sys.argv[1], 'tests/faults', table), encoding='utf-8'):
        fields = [field.strip() for field in fault.split(' | ')]
        if fault.startswith('#') or len(fields) < column + 3:
            continue
        path = os.path.join(sys.argv[1], base + fields[column])
        planted = subprocess.run(['sed', fields[column + 1], path], capture_output=True, text=True, check=False)
        if planted.returncode or planted.stdout == open(path, encoding='utf-8').read():
            failures.append("tests/faults/%s: '%s' changes nothing in %s" % (table, fields[-1], fields[column]))

print('\n'.join(failures) or 'The %d files keep %d rules.' % (len(tree), len(RULES)))
sys.exit(1 if failures else 0)
