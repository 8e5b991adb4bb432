#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Polylume authors
# SPDX-License-Identifier: MIT
"""count_operations.py [--check | --write]: counts what the lighting shaders compute and read, for `polylume bench`.

Expands passes/lighting.frag for each kind of light and each model, compiles it to SPIR-V, inlines and simplifies it with
spirv-opt, finds the loops over lights, contours and edges, and counts what is in each: once in each loop that it is in.
Prints the table; --write puts it into engine/bench/operation_table.inc, --check says where that disagrees and fails.

What is counted, per scalar: addition, subtraction, multiplication, minimum, maximum, comparison, selection, logic,
conversion 1 each, a fused multiply-add 2, a dot product of n components 2n - 1; negation, absolute value, moves and
addresses nothing. "Special" are divisions, roots, exponentials and logarithms. Of a branch both sides count, as a software
rasteriser runs them; of a loop over reads of an image one turn. "Bytes" are loaded from buffers and by texel fetches,
without filtered reads of images, which "samples" counts.

Needs glslangValidator, spirv-as, spirv-dis and spirv-opt (Debian: glslang-tools). Exit codes: 0 done, 1 the table disagrees,
77 a tool is missing.
"""

import concurrent.futures
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TABLE = ROOT / "engine/bench/operation_table.inc"
TOOLS = ("glslangValidator", "spirv-as", "spirv-dis", "spirv-opt")
# Counts of other versions of these tools may differ a little from those of the table.
OTHER_VERSION_TOLERANCE = 0.05

KINDS = {
    "parallelogram": "POLYLUME_PARALLELOGRAM_LIGHTS",
    "triangle": "POLYLUME_TRIANGLE_LIGHTS",
    "polygon": "POLYLUME_POLYGON_LIGHTS",
    "texturedParallelogram": "POLYLUME_TEXTURED_PARALLELOGRAM_LIGHTS",
    "texturedPolygon": "POLYLUME_TEXTURED_POLYGON_LIGHTS",
    "disk": "POLYLUME_DISK_LIGHTS",
    "ellipse": "POLYLUME_ELLIPSE_LIGHTS",
    "sphere": "POLYLUME_SPHERE_LIGHTS",
    "tube": "POLYLUME_TUBE_LIGHTS",
}
MODELS = {
    "oneLobe": [],
    "twoLobes": ["POLYLUME_TWO_LOBES"],
    "burley": ["POLYLUME_DIFFUSE_BURLEY"],
    "sheen": ["POLYLUME_SHEEN"],
    "everything": ["POLYLUME_TWO_LOBES", "POLYLUME_DIFFUSE_BURLEY", "POLYLUME_SHEEN"],
}
TEXTBOOK = "engine/bench/glsl/textbook.frag"
TEXTBOOK_VARIANTS = {"oneLookup": [], "lookupPerLight": ["BENCH_LOOKUP_PER_LIGHT"]}
SCOPES = ("pixel", "light", "contour", "edge")

TEXEL_BYTES = {"gbufferNormal": 8, "gbufferDiffuseRoughness": 8, "gbufferSpecular": 8, "gbufferSheen": 8,
               "gbufferDepth": 4}

FREE = set("""OpLabel OpBranch OpBranchConditional OpSelectionMerge OpLoopMerge OpPhi OpAccessChain OpCompositeExtract
    OpCompositeConstruct OpCompositeInsert OpVectorShuffle OpVectorExtractDynamic OpVectorInsertDynamic OpImage OpStore
    OpVariable OpCopyObject OpUndef OpReturn OpKill OpUnreachable OpSwitch OpFNegate OpSNegate OpBitcast OpTranspose
    OpImageQuerySizeLod OpImageQuerySize OpSampledImage OpFunctionEnd OpNop""".split())
SIMPLE = set("""OpFAdd OpFSub OpFMul OpIAdd OpISub OpIMul OpVectorTimesScalar OpMatrixTimesScalar OpSelect OpFOrdEqual
    OpFOrdNotEqual OpFUnordNotEqual OpFOrdLessThan OpFOrdLessThanEqual OpFOrdGreaterThan OpFOrdGreaterThanEqual
    OpFUnordEqual OpFUnordLessThan OpFUnordLessThanEqual OpFUnordGreaterThan OpFUnordGreaterThanEqual OpIEqual OpINotEqual
    OpSLessThan OpSLessThanEqual OpSGreaterThan OpSGreaterThanEqual OpULessThan OpULessThanEqual OpUGreaterThan
    OpUGreaterThanEqual OpLogicalAnd OpLogicalOr OpLogicalNot OpLogicalEqual OpLogicalNotEqual OpBitwiseAnd OpBitwiseOr
    OpBitwiseXor OpNot OpShiftLeftLogical OpShiftRightLogical OpShiftRightArithmetic OpConvertFToS OpConvertFToU
    OpConvertSToF OpConvertUToF OpAny OpAll OpIsNan OpIsInf OpBitCount""".split())
SPECIAL = {"OpFDiv", "OpFMod", "OpFRem", "OpUDiv", "OpSDiv", "OpUMod", "OpSMod"}
# Of extended instructions: simple and special operations per component.
EXTENDED = {"FAbs": (0, 0), "SAbs": (0, 0), "FSign": (2, 0), "SSign": (2, 0), "Floor": (1, 0), "Ceil": (1, 0),
            "Round": (1, 0), "RoundEven": (1, 0), "Trunc": (1, 0), "Fract": (2, 0), "FMin": (1, 0), "FMax": (1, 0),
            "NMin": (1, 0), "NMax": (1, 0), "UMin": (1, 0), "UMax": (1, 0), "SMin": (1, 0), "SMax": (1, 0), "FClamp": (2, 0),
            "NClamp": (2, 0), "UClamp": (2, 0), "SClamp": (2, 0), "FMix": (3, 0), "Step": (1, 0), "SmoothStep": (7, 1),
            "Fma": (2, 0), "Ldexp": (1, 0), "FindILsb": (1, 0), "FindUMsb": (1, 0), "Cross": (3, 0), "Sqrt": (0, 1),
            "InverseSqrt": (0, 1), "Exp": (0, 1), "Exp2": (0, 1), "Log": (0, 1), "Log2": (0, 1), "Pow": (1, 2),
            "Sin": (0, 1), "Cos": (0, 1), "Tan": (0, 1), "Asin": (0, 1), "Acos": (0, 1), "Atan": (0, 1), "Atan2": (1, 1)}


class UnknownShader(Exception):
    """The shaders are not of the structure that is counted."""


def flatten(path):
    """A shader with what it includes, by the script that hosts flatten theirs with."""
    spec = importlib.util.spec_from_file_location("flatten", ROOT / "glsl/flatten.py")
    module = importlib.util.module_from_spec(spec)
    sys.dont_write_bytecode = True
    spec.loader.exec_module(module)
    return module.flatten([path])


def run(*command):
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise UnknownShader(f"{command[0]} failed:\n{result.stdout}{result.stderr}")
    return result.stdout


def disassemble(source, folder):
    """The one function that is left of a fragment shader, as lines of SPIR-V."""
    shader = folder / "shader.frag"
    shader.write_text(source, encoding="utf-8")
    binary, edited, text = folder / "a.spv", folder / "b.spv", folder / "a.txt"
    run("glslangValidator", "-G", "--aml", "--amb", "-S", "frag", str(shader), "-o", str(binary))
    run("spirv-dis", str(binary), "--no-color", "-o", str(text))
    # Loops of a constant number of turns are unrolled where they ask for it.
    loops = re.sub(r"(OpLoopMerge \S+ \S+) None", r"\1 Unroll", text.read_text(encoding="utf-8"))
    text.write_text(loops, encoding="utf-8")
    run("spirv-as", "--target-env", "spv1.0", "--preserve-numeric-ids", str(text), "-o", str(edited))
    run("spirv-opt", "-O", "--redundancy-elimination", "-O", str(edited), "-o", str(binary))
    return run("spirv-dis", str(binary), "--no-color").splitlines()


class Module:
    """What a disassembly says: types, names, and the blocks of its one function."""

    def __init__(self, lines):
        self.types, self.type_of, self.names, self.constants = {}, {}, {}, {}
        self.blocks, self.order = {}, []
        block = None
        for line in lines:
            words = line.split(";")[0].split()
            if not words:
                continue
            result = None
            if len(words) > 2 and words[1] == "=":
                result, words = words[0], words[2:]
            operation, operands = words[0], words[1:]
            if operation == "OpName":
                self.names[operands[0]] = operands[1].strip('"')
            elif operation.startswith("OpType"):
                self.types[result] = (operation, operands)
            elif operation == "OpConstant":
                self.constants[result] = operands[1]
            elif operation == "OpLabel":
                block = result
                self.blocks[block] = []
                self.order.append(block)
                continue
            elif operation == "OpFunctionEnd":
                block = None
            if result and operands and operands[0] in self.types and not operation.startswith("OpType"):
                self.type_of[result] = operands[0]
            if block:
                self.blocks[block].append((result, operation, operands))

    def width(self, kind):
        operation, operands = self.types[kind]
        if operation in ("OpTypeVector", "OpTypeMatrix"):
            return self.width(operands[0]) * int(operands[1])
        return 1

    def size(self, kind):
        """Bytes of a value, without the padding of its block."""
        operation, operands = self.types[kind]
        if operation in ("OpTypeVector", "OpTypeMatrix"):
            return self.size(operands[0]) * int(operands[1])
        if operation == "OpTypeArray":
            return self.size(operands[0]) * int(self.constants[operands[1]])
        if operation == "OpTypeStruct":
            return sum(self.size(member) for member in operands)
        return 4

    def targets(self, block):
        _, operation, operands = self.blocks[block][-1]
        if operation == "OpBranch":
            return operands
        if operation == "OpBranchConditional":
            return operands[1:3]
        if operation == "OpSwitch":
            return [operand for operand in operands[1:] if operand.startswith("%")]
        return []

    def loops(self):
        """Each loop's header with the set of its blocks."""
        found = {}
        for header in self.order:
            merge = [operands[0] for _, operation, operands in self.blocks[header] if operation == "OpLoopMerge"]
            if not merge:
                continue
            blocks, waiting = set(), [header]
            while waiting:
                block = waiting.pop()
                if block in blocks or block == merge[0]:
                    continue
                blocks.add(block)
                waiting.extend(self.targets(block))
            found[header] = blocks
        return found


def is_buffer(module, pointer):
    """Whether a load from `pointer` reads a buffer."""
    kind = module.types[module.type_of[pointer]]
    return kind[0] == "OpTypePointer" and kind[1][0] in ("Uniform", "StorageBuffer")


def count_block(module, block, defined):
    """[operations, specials, bytes, samples] of one block."""
    simple = special = size = samples = 0
    for result, operation, operands in module.blocks[block]:
        width = module.width(module.type_of[result]) if result in module.type_of else 0
        if operation in FREE:
            continue
        if operation in SIMPLE:
            simple += width
        elif operation in SPECIAL:
            special += width
        elif operation == "OpDot":
            simple += 2 * module.width(module.type_of[operands[1]]) - 1
        elif operation in ("OpMatrixTimesVector", "OpVectorTimesMatrix"):
            vector = operands[2] if operation == "OpMatrixTimesVector" else operands[1]
            simple += width * (2 * module.width(module.type_of[vector]) - 1)
        elif operation == "OpMatrixTimesMatrix":
            inner = int(module.types[module.type_of[operands[1]]][1][1])
            simple += width * (2 * inner - 1)
        elif operation == "OpLoad":
            if is_buffer(module, operands[1]):
                size += module.size(operands[0])
        elif operation == "OpImageFetch":
            size += TEXEL_BYTES.get(image_name(module, operands[1], defined), 16)
        elif operation.startswith("OpImageSample"):
            samples += 1
        elif operation == "OpExtInst":
            one, other = extended(module, operands, width)
            simple += one
            special += other
        else:
            raise UnknownShader(f"expected operations that are counted, found {operation}: add it to this script")
    return [simple, special, size, samples]


def extended(module, operands, width):
    name = operands[2]
    components = module.width(module.type_of[operands[3]])
    if name == "Normalize":
        return 3 * components - 1, 1
    if name in ("Length", "Distance"):
        return 2 * components - 1 + (components if name == "Distance" else 0), 1
    if name == "Reflect":
        return 4 * components, 0
    if name not in EXTENDED:
        raise UnknownShader(f"expected operations that are counted, found {name}: add it to this script")
    return tuple(width * share for share in EXTENDED[name])


def image_name(module, image, defined):
    """The sampler's name that an image was loaded from."""
    while image in defined:
        operation, operands = defined[image]
        if operation not in ("OpImage", "OpLoad"):
            break
        image = operands[1]
    return module.names.get(image, image.lstrip("%"))


def find_scopes(module, kind):
    """The scope of each loop's header: that of its own blocks."""
    loops = module.loops()
    parent = {}
    for header, blocks in loops.items():
        outer = [other for other in loops if other != header and header in loops[other]]
        parent[header] = min(outer, key=lambda other: len(loops[other]), default=None)
    leaves = [header for header in loops if header not in parent.values()]

    def uses(header, prefix):
        return any(operation.startswith(prefix) for block in loops[header] for _, operation, _ in module.blocks[block])

    scopes = {}
    is_polygon = kind in ("polygon", "texturedPolygon")
    for leaf in leaves:
        if is_polygon and not uses(leaf, "OpImageSample"):
            outer = parent[leaf]
            if outer is None or parent[outer] is None:
                raise UnknownShader(f"expected loops over edges, contours and lights for {kind}, found fewer")
            scopes.update({leaf: "edge", outer: "contour", parent[outer]: "light"})
        elif parent[leaf] is not None and uses(leaf, "OpImageSample"):
            scopes.update({leaf: "light", parent[leaf]: "light"})
        elif not is_polygon:
            scopes[leaf] = "light"
    if "light" not in scopes.values():
        raise UnknownShader(f"expected a loop over lights for {kind}, found none")
    return loops, scopes


def count_shader(lines, kind):
    """[operations, specials, bytes, samples] of each scope."""
    module = Module(lines)
    defined = {result: (operation, operands)
               for block in module.order for result, operation, operands in module.blocks[block] if result}
    loops, scopes = find_scopes(module, kind)
    counts = {scope: [0, 0, 0, 0] for scope in SCOPES}
    for block in module.order:
        around = [header for header in loops if block in loops[header]]
        innermost = min(around, key=lambda header: len(loops[header]), default=None)
        scope = scopes.get(innermost, "pixel")
        counts[scope] = [a + b for a, b in zip(counts[scope], count_block(module, block, defined))]
    return counts


def count_one(task):
    """A row of the table: kind, model, counts."""
    kind, model, body, defines = task
    source = "#version 450 core\n" + "".join(f"#define {name}\n" for name in defines) + body
    with tempfile.TemporaryDirectory() as folder:
        return kind, model, count_shader(disassemble(source, pathlib.Path(folder)), kind)


def count_all():
    lighting = flatten("passes/lighting.frag")
    tasks = [(kind, model, lighting, [define, "POLYLUME_SHADES_ALL", *defines])
             for kind, define in KINDS.items() for model, defines in MODELS.items()]
    textbook = flatten(str(ROOT / TEXTBOOK))
    tasks += [("textbook", model, textbook, ["POLYLUME_PARALLELOGRAM_LIGHTS", *defines])
              for model, defines in TEXTBOOK_VARIANTS.items()]
    # The work is that of the tools.
    with concurrent.futures.ThreadPoolExecutor() as pool:
        return list(pool.map(count_one, tasks))


def tool_versions():
    glslang = run("glslangValidator", "--version").splitlines()[0].split(":")[-1]
    # This one answers on either stream.
    answer = subprocess.run(["spirv-opt", "--version"], capture_output=True, text=True, check=False)
    tools = re.search(r"v?20\d\d\.\S+", answer.stdout + answer.stderr)
    return f"glslang {glslang.strip()}, SPIRV-Tools {tools[0].rstrip(',') if tools else 'of no known version'}"


def table_text(rows):
    text = ("// SPDX-FileCopyrightText: 2026 The Polylume authors\n// SPDX-License-Identifier: MIT\n"
            "// Written by tests/bench/count_operations.py; do not edit.\n"
            f"// Tools: {tool_versions()}\n"
            "// {kind, model, {operations, specials, bytes, samples} per pixel, light, contour, edge}\n")
    for kind, model, counts in rows:
        scopes = ", ".join("{" + ", ".join(str(value) for value in counts[scope]) + "}" for scope in SCOPES)
        text += f'{{"{kind}", "{model}", {scopes}}},\n'
    return text


def numbers_of(text):
    return {tuple(re.findall(r'"(\w+)"', line)): [int(n) for n in re.findall(r"\b\d+\b", line)]
            for line in text.splitlines() if line.startswith("{")}


def check(text):
    """What the file says otherwise."""
    stored = TABLE.read_text(encoding="utf-8") if TABLE.is_file() else ""
    line = f"// Tools: {tool_versions()}"
    tolerance = 0.0 if line in stored.splitlines() else OTHER_VERSION_TOLERANCE
    counted, expected = numbers_of(text), numbers_of(stored)
    faults = []
    for row in sorted(set(counted) | set(expected)):
        found, kept = counted.get(row), expected.get(row)
        if found is None or kept is None or len(found) != len(kept) or any(
                abs(a - b) > tolerance * max(a, b) for a, b in zip(found, kept)):
            faults.append(f"{' '.join(row)}: the shaders have {found}, the table {kept}")
    return faults


def main():
    arguments = sys.argv[1:]
    if arguments not in ([], ["--check"], ["--write"]):
        print(f"usage: {__doc__.strip()}", file=sys.stderr)
        return 2
    missing = [tool for tool in TOOLS if shutil.which(tool) is None]
    if missing:
        print(f"expected {', '.join(missing)}: install the Debian package glslang-tools", file=sys.stderr)
        return 77
    text = table_text(count_all())
    if arguments == ["--write"]:
        TABLE.write_text(text, encoding="utf-8")
    elif arguments == ["--check"]:
        faults = check(text)
        for fault in faults:
            print(fault, file=sys.stderr)
        if faults:
            print("the shaders have changed: run tests/bench/count_operations.py --write", file=sys.stderr)
            return 1
    else:
        print(text, end="")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except UnknownShader as fault:
        print(f"count_operations.py: {fault}", file=sys.stderr)
        sys.exit(1)
