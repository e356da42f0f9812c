"""Writes a scene with an exported glTF material as one binary file, for programs that load models and not materials."""
import json
import struct

# A triangle in z = 0 with the origin inside, so that no pixel there lies on an edge; tangent +x, bitangent +y.
CORNERS = [(-2, -1), (2, -1), (0, 3)]
ARRAYS = {
    "POSITION": ("VEC3", [(x, y, 0) for x, y in CORNERS]),
    "NORMAL": ("VEC3", [(0, 0, 1)] * 3),
    "TANGENT": ("VEC4", [(1, 0, 0, 1)] * 3),
    "TEXCOORD_0": ("VEC2", [(x / 4 + 0.5, 0.5 - y / 4) for x, y in CORNERS]),
}
FLOAT, ARRAY_BUFFER = 5126, 34962


def with_mesh(document):
    """Returns the document with the triangle, and the bytes of its buffer."""
    data, views, accessors = b"", [], []
    for kind, rows in ARRAYS.values():
        part = b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(part), "target": ARRAY_BUFFER})
        accessors.append({"bufferView": len(views) - 1, "componentType": FLOAT, "count": len(rows), "type": kind,
                          "min": [min(column) for column in zip(*rows)], "max": [max(column) for column in zip(*rows)]})
        data += part
    attributes = {name: k for k, name in enumerate(ARRAYS)}
    return document | {"buffers": [{"byteLength": len(data)}], "bufferViews": views, "accessors": accessors,
                       "meshes": [{"primitives": [{"attributes": attributes, "material": 0}]}]}, data


def around(material):
    """Returns the bytes of a .glb: the material of the exported text on the triangle under a directional light of illuminance 1,
    with an orthographic camera. The nodes `light` and `camera` look along -z from the origin."""
    document, data = with_mesh(json.loads(material))
    document["extensionsUsed"] = document.get("extensionsUsed", []) + ["KHR_lights_punctual"]
    document["extensions"] = {"KHR_lights_punctual": {"lights": [{"type": "directional", "intensity": 1}]}}
    width = 1e-5
    document["cameras"] = [{"type": "orthographic",
                            "orthographic": {"xmag": width, "ymag": width, "znear": 1, "zfar": 10}}]
    document["nodes"] = [{"name": "plane", "mesh": 0}, {"name": "camera", "camera": 0},
                         {"name": "light", "extensions": {"KHR_lights_punctual": {"light": 0}}}]
    document |= {"scenes": [{"nodes": [0, 1, 2]}], "scene": 0}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
