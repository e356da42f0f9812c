"""Reads the pixels of a virtual screen and of PNG files as rows of (red, green, blue).

Usage as a program: pixels.py PICTURE.png SMALLER.webp
"""
import ctypes
import mmap
import struct
import sys
import zlib


def screen(xwd_file, left, top, width, height):
    """Returns the rows of the frame buffer that Xvfb keeps in a file (-fbdir), an X window dump of 32 bits per pixel."""
    with open(xwd_file, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as data:
        header = struct.unpack(">25I", data[:100])
        line, start = header[12], header[0] + 12 * header[19]
        little = header[7] == 0
        assert header[11] == 32, f"{header[11]} bits a pixel"
        rows = []
        for y in range(top, top + height):
            row = data[start + y * line + 4 * left:start + y * line + 4 * (left + width)]
            rows.append([tuple(row[k:k + 4][2::-1] if little else row[k + 1:k + 4]) for k in range(0, len(row), 4)])
        return rows


def png(content):
    """Returns the rows of a PNG file with 8-bit RGB without interlacing."""
    at, size, data = 8, None, b""
    while at < len(content):
        length, kind = struct.unpack(">I4s", content[at:at + 8])
        body = content[at + 8:at + 8 + length]
        at += 12 + length
        if kind == b"IHDR":
            size = struct.unpack(">IIBBBBB", body)
            assert size[2:] == (8, 2, 0, 0, 0), size
        if kind == b"IDAT":
            data += body
    width, height, step = size[0], size[1], 3
    raw, rows, before = zlib.decompress(data), [], bytes(3 * size[0])
    for y in range(height):
        row = bytearray(raw[y * (step * width + 1) + 1:(y + 1) * (step * width + 1)])
        kind = raw[y * (step * width + 1)]
        for k in range(len(row)):
            left, up, corner = (row[k - step] if k >= step else 0), before[k], (before[k - step] if k >= step else 0)
            near = left + up - corner
            row[k] = (row[k] + (0, left, up, (left + up) // 2,
                                min((left, up, corner), key=lambda v: abs(near - v)))[kind]) & 255
        before = bytes(row)
        rows.append([tuple(before[k:k + step]) for k in range(0, len(before), step)])
    return rows


def write_png(path, rows):
    """Writes rows of pixels as PNG."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    raw = b"".join(b"\0" + bytes(v for pixel in row for v in pixel) for row in rows)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def write_webp(path, rows, quality=80):
    """Writes rows of pixels as lossy WebP with libwebp, which takes a tenth of the bytes of PNG."""
    encoder = ctypes.CDLL("libwebp.so.7")
    encoder.WebPEncodeRGB.restype = ctypes.c_size_t
    encoder.WebPEncodeRGB.argtypes = [ctypes.c_char_p, ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_float,
                                      ctypes.POINTER(ctypes.c_void_p)]
    height, width, out = len(rows), len(rows[0]), ctypes.c_void_p()
    raw = bytes(v for row in rows for pixel in row for v in pixel)
    size = encoder.WebPEncodeRGB(raw, width, height, 3 * width, quality, ctypes.byref(out))
    assert size > 0, "libwebp has encoded nothing"
    content = ctypes.string_at(out, size)
    encoder.WebPFree.argtypes = [ctypes.c_void_p]
    encoder.WebPFree(out)
    with open(path, "wb") as file:
        file.write(content)


if __name__ == "__main__":
    with open(sys.argv[1], "rb") as picture:
        write_webp(sys.argv[2], png(picture.read()))
