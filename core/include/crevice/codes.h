// SPDX-License-Identifier: MIT
// The codes of all diagnostics. A code never changes its meaning and is never used again.
//
//   CV1xxx  reading: text, merging, finding modules      CV5xxx  shaders
//   CV2xxx  references between the parts of a config     CV6xxx  devices and contexts
//   CV3xxx  keys and types                               CV7xxx  scenes, images, files
//   CV4xxx  values and ranges                            CV8xxx  the command line
//                                                        CV9xxx  what a frame's targets hold
#pragma once

namespace crevice {

enum class Code : int {
    internal = 1,  ///< A fault in crevice itself.

    // reading
    syntax = 1001,            ///< Not JSON.
    duplicate_key = 1002,     ///< The same key twice in one object.
    number_range = 1003,      ///< A number that no double holds, such as 1e999.
    bad_utf8 = 1004,          ///< Text that is not UTF-8, or that begins with a byte order mark.
    too_deep = 1005,          ///< More than 64 levels.
    too_large = 1006,         ///< More than 1 MiB.
    not_an_object = 1007,     ///< A file whose top value is not an object.
    empty_text = 1008,        ///< Nothing but white space and comments.
    too_many_members = 1009,  ///< An object with more than 1024 members.
    merge_missing = 1101,     ///< A patch deletes what is not there.
    merge_kind = 1102,        ///< A patch turns an object into something else, or the reverse.
    module_missing = 1201,    ///< `extends` or the command line names what does not exist.
    module_cycle = 1202,      ///< `extends` leads back to itself.
    module_depth = 1203,      ///< `extends` is more than 8 deep.
    module_escape = 1204,     ///< A path out of the modules, or of the folders that may be read.
    variant_missing = 1205,   ///< No such variant.
    override_syntax = 1206,   ///< An override that is not name=value.
    format_version = 1207,    ///< `format` is missing or newer than this library.
    module_clash = 1208,      ///< Two modules in `extends` that provide the same part.
    over_limit = 1209,        ///< More files, passes, targets or bytes than `Limits` allow.
    baked_broken = 1301,      ///< Bytes that are no baked effect, or a damaged one.
    baked_version = 1302,     ///< A baked effect of another version of crevice.

    // references and graph
    shader_missing = 2101,      ///< A pass names a shader that is not declared.
    reference_missing = 2102,   ///< A name that refers to nothing (import, interface, param, ...).
    target_missing = 2103,      ///< A pass or output names a target that does not exist.
    file_missing = 2104,        ///< A shader names a GLSL file that does not exist.
    feature_missing = 2105,     ///< A condition names neither a feature nor a trait.
    feature_value = 2106,       ///< A condition names a value that the feature does not have.
    name_collision = 2107,      ///< One name for two objects that GLSL would see under one name.
    unused_name = 2108,         ///< Something declared that nothing uses.
    two_writers = 2201,         ///< Two active passes write one target.
    never_written = 2202,       ///< Something reads a target that no active pass writes.
    reads_own_output = 2203,    ///< A pass reads what it writes.
    cycle = 2204,               ///< Passes wait for each other.
    no_outputs = 2205,          ///< Nothing is asked for.
    attachment_size = 2206,     ///< Attachments of one pass differ in size.
    attachment_kind = 2207,     ///< A depth format as colour, or a colour format as depth.
    bypass_class = 2208,        ///< A bypass has depth stand in for colour, or the reverse.
    output_missing = 2209,      ///< An output that the config does not export was asked for.
    attachment_samples = 2210,  ///< Attachments differ in samples.
    cannot_filter = 2211,       ///< A linear read, or a blend, of a format that no device filters.
    dead_pass = 2212,     ///< A pass that no output needs, whichever is asked for (a warning).
    box_input = 2213,     ///< A pass of a box reads what the camera sees.
    no_draw_list = 2214,  ///< A pass draws the scene, which nothing imports.
    not_baked = 2301,     ///< Something that a baked effect was not baked for.

    // keys and types
    unknown_key = 3001,  ///< A key that the format does not have.
    wrong_type = 3002,   ///< A value of another type than wanted.
    missing_key = 3003,  ///< A key that must be there is not.
    bad_name = 3004,     ///< A name that is not snake_case or that GLSL reserves.
    bad_enum = 3005,     ///< A word that is not among the allowed ones.
    bad_length = 3006,   ///< A list with too few or too many entries.

    // values
    out_of_range = 4001,   ///< A value outside its range.
    bad_range = 4002,      ///< min above max, or a default outside them.
    not_finite = 4003,     ///< NaN or infinity.
    unknown_param = 4004,  ///< A value for a param, pass or the like that is not there.
    bad_size = 4005,       ///< A size that is not positive or that the device cannot hold.
    value_dropped = 4006,  ///< A value set at run time that a reloaded config has no place for.

    // shaders
    shader_compile = 5001,   ///< GLSL does not compile.
    shader_link = 5002,      ///< GLSL does not link.
    uniform_unbound = 5003,  ///< GLSL declares a uniform that nothing in the config supplies.
    uniform_type = 5004,     ///< GLSL and the config disagree about a type or an array length.
    include_missing = 5005,  ///< An #include names what does not exist.
    include_cycle = 5006,    ///< An #include leads back to itself, or is more than 64 deep.
    input_unused = 5007,     ///< A pass renames an input that its shader does not declare.
    output_mismatch = 5008,  ///< A fragment shader's outputs are not the pass's colour targets.
    preprocessor = 5009,     ///< A directive that cannot be read.
    recompiled = 5010,       ///< A value set at run time made shaders compile.

    // devices and contexts
    no_egl = 6001,       ///< No EGL library, display or configuration.
    no_osmesa = 6002,    ///< No OSMesa library or context.
    gl_function = 6003,  ///< A GL function that must be there is not.
    gl_version = 6004,  ///< No context, another than the device's, or one older than OpenGL ES 3.0.
    gl_error = 6005,    ///< The driver reported an error.
    no_format = 6006,   ///< No format of a preference list can be rendered to.
    too_big_for_device = 6007,  ///< A texture or mesh larger than the device holds.
    too_many = 6008,            ///< More attachments, samplers or uniforms than the device has.
    out_of_memory = 6009,       ///< The device has no memory left.
    missing_import = 6010,      ///< The host did not supply something that is not optional.
    bad_input = 6011,           ///< The host supplied something unusable.
    no_backend = 6012,          ///< A backend that does not exist or was not built.
    no_samples = 6013,          ///< More samples than the device draws.
    sampler_version = 6014,     ///< A sampler that the device's version of OpenGL ES does not have.
    too_coarse = 6015,    ///< Formats that do not resolve the radius where it is seen (a warning).
    context_lost = 6016,  ///< The context is gone, and all that was made in it.
    host_busy = 6017,     ///< The host is amid what drawing would spoil, such as a query.
    no_timers = 6018,     ///< The GPU's time cannot be measured (a warning).
    mesh_lacks = 6019,    ///< A pass reads normals or uv that a mesh does not have (a warning).
    unfilled_block = 6020,  ///< A uniform block that nobody fills (a warning).
    no_compilers = 6021,    ///< The compilers of phones' GPUs are not there, or do not work.
    cannot_serve = 6022,    ///< No port to serve on, or no random number for its address.

    // scenes, images, files
    scene_missing = 7001,   ///< A scene file that does not exist.
    scene_broken = 7002,    ///< A scene file that cannot be read.
    scene_empty = 7003,     ///< A scene without a triangle.
    camera_missing = 7004,  ///< A camera that the scene does not have.
    image_broken = 7005,    ///< An image that cannot be read.
    image_size = 7006,      ///< Images that differ in size.
    cannot_write = 7007,    ///< A file or folder that cannot be written.
    nothing_seen = 7008,    ///< A camera that sees no surface.
    results_broken = 7009,  ///< Bench results that cannot be read.
    scene_features = 7010,  ///< A scene file that is not drawn as it is (a warning).
    page_missing = 7011,    ///< The page of `crevice view` is not there.

    // what a frame's targets hold (crevice doctor)
    target_not_finite = 9001,    ///< A pass writes what is not a number or is infinite.
    target_undefined = 9002,     ///< A pass leaves pixels that depend on what memory held before.
    output_constant = 9003,      ///< An output is the same everywhere.
    target_out_of_range = 9004,  ///< A pass writes values that its target's format clamps.
    answer_wrong = 9005,  ///< AO or light is worse than a shipped config's, or breaks its promise.

    // command line
    usage = 8001,  ///< Arguments that cannot be understood.
};

}  // namespace crevice
