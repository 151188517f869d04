# SPDX-License-Identifier: MIT
# Holds docs/config.schema.json against every shipped file, and against files with one mistake each.
#   schema_check.py SOURCE
import json
import pathlib
import sys

import jsonschema

source = pathlib.Path(sys.argv[1])
schema = json.loads((source / "docs/config.schema.json").read_text())
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
failures = 0


def fail(text):
    global failures
    failures += 1
    print("FAILED:", text)


shipped = sorted(source.glob("configs/**/*.json")) + sorted(source.glob("effects/*/*.json"))
for path in shipped:
    for error in validator.iter_errors(json.loads(path.read_text())):
        fail(f"{path}: {error.json_path}: {error.message}")
if len(shipped) < 40:
    fail(f"found only {len(shipped)} configs and modules")

GOOD = [
    {"$schema": "./config.schema.json"},
    {"x-mine": [1, {"any": "thing"}], "params": {"x-note": 1, "radius": {"x-note": None}}},
    {"extends": ["ssao/gtao", "./mine.json"], "passes": {"filter": None}},
    {"params": {"radius": {"default": 2, "soft_max": None}, "tint": {"default": [1, 0, 0]}}},
    {"variants": {"cheap": {"params": {"radius": {"default": 1}}, "passes": {"filter": None}}}},
    {"params": {"radius": 2, "tint": [1, 0, 0], "gone": None}, "features": {"fade": "b", "half": False}},
    {"targets": {"ao": {"format": "r8", "size": {"scale": "half"}, "samples": "msaa"}}},
    {"passes": {"ssao": {"inputs": {"depth": "depth_back", "normal": {"filter": "linear"}}}}},
    {"passes": {"ssao": {"when": {"scene.lights": True}, "clear": {"ao": [1, 1, 1, 1]}, "color": []}}},
    {"features": {"fade": {"type": "enum", "values": ["a", "b"], "default": "b"}}},
    {"shaders": {"ssao": {"defines": {"TAPS": 4, "DEBUG": True}}}},
    {"passes": {"mine": {"shader": "mine", "color": ["mine", "ao"], "depth": None, "bypass": {"ao": "mine"}}}},
    {"outputs": {"mine": "mine"}, "targets": {"mine": {"format": "r8", "size": {"of": "mine"}}}},
]
BAD = [
    {"pases": {}},
    {"extends": "ssao/gtao"},
    {"extends": [1]},
    {"format": 2},
    {"name": 1},
    {"params": {"radius": {"defalt": 1}}},
    {"params": {"radius": {"default": "wide"}}},
    {"params": {"radius": {"default": [1]}}},
    {"params": {"radius": {"type": "double"}}},
    {"params": {"radius": {"min": 1e31}}},
    {"params": {"Radius": {"default": 1}}},
    {"features": {"fade": {"values": ["a"]}}},
    {"targets": {"ao": {"format": ["r9"]}}},
    {"targets": {"ao": {"size": {"scale": 100}}}},
    {"shaders": {"ssao": {"defines": {"GL_x": 1}}}},
    {"passes": {"ssao": {"state": {"cull": "both"}}}},
    {"passes": {"ssao": {"when": {"fade": []}}}},
]
for case in GOOD:
    for error in validator.iter_errors({"format": 1, **case}):
        fail(f"{case} should be accepted: {error.json_path}: {error.message}")
for case in BAD:
    if validator.is_valid({"format": 1, **case}):
        fail(f"{case} should be refused")
if validator.is_valid({"name": "no format"}):
    fail("a file without 'format' should be refused")

offered = schema["properties"]["extends"]["items"]["anyOf"][0]["enum"]
if "ssao/gtao" not in offered or "learnopengl" not in offered:
    fail("'extends' offers no modules and configs")
if "radius" not in schema["definitions"]["params"]["properties"]:
    fail("'params' offers no names")

for kind, name in ("target_name", "ao_filtered"), ("shader_name", "lighting"):
    if name not in schema["definitions"][kind]["anyOf"][0]["enum"]:
        fail(f"'{kind}' offers no '{name}'")
entry = next(form for pattern, form in schema["definitions"]["passes"]["patternProperties"].items() if pattern != "^x-")
for key in "shader", "color", "depth", "bypass", "inputs":
    if "_name" not in json.dumps(entry["properties"][key]):
        fail(f"'{key}' of a pass offers no names")

print(f"{len(shipped)} files, {len(GOOD) + len(BAD)} cases, {failures} failures")
sys.exit(failures > 0)
