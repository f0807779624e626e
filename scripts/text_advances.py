#!/usr/bin/env python3
"""Prints the table of studies/texts/text_advances.cpp: how wide the characters of the boards' fonts are.
   scripts/text_advances.py REGULAR.ttf BOLD.ttf >studies/texts/text_advances.cpp"""
import struct
import sys


def tables(data):
    count = struct.unpack(">H", data[4:6])[0]
    entries = (struct.unpack(">4sLLL", data[12 + 16 * i : 28 + 16 * i]) for i in range(count))
    return {tag.decode(): offset for tag, _, offset, _ in entries}


def glyphs(data, cmap):
    """The glyph of each character, from the subtable of Windows and Unicode's first plane (format 4)."""
    for i in range(struct.unpack(">H", data[cmap + 2 : cmap + 4])[0]):
        platform, _, offset = struct.unpack(">HHL", data[cmap + 4 + 8 * i : cmap + 12 + 8 * i])
        at = cmap + offset
        if platform == 3 and struct.unpack(">H", data[at : at + 2])[0] == 4:
            break
    else:
        sys.exit("text_advances.py: a font without a character map of format 4")
    segments = struct.unpack(">H", data[at + 6 : at + 8])[0] // 2

    def row(number, sign="H"):
        start = at + 14 + 2 * segments * number + (2 if number else 0)
        return struct.unpack(f">{segments}{sign}", data[start : start + 2 * segments])

    found = {}
    for i, (last, first, delta, offset) in enumerate(zip(row(0), row(1), row(2, "h"), row(3))):
        for character in range(first, last + 1):
            glyph = character
            if offset:
                place = at + 16 + 6 * segments + 2 * i + offset + 2 * (character - first)
                glyph = struct.unpack(">H", data[place : place + 2])[0]
            if (not offset or glyph) and character != 0xFFFF:
                found[character] = (glyph + delta) & 0xFFFF
    return {character: glyph for character, glyph in found.items() if glyph}


def advances(path):
    """Of each character, and a line's height, in the font's units."""
    data = open(path, "rb").read()
    at = tables(data)
    ascent, descent = struct.unpack(">hh", data[at["hhea"] + 4 : at["hhea"] + 8])
    metrics = struct.unpack(">H", data[at["hhea"] + 34 : at["hhea"] + 36])[0]

    def advance(glyph):
        place = at["hmtx"] + 4 * min(glyph, metrics - 1)
        return struct.unpack(">H", data[place : place + 2])[0]

    return {c: advance(glyph) for c, glyph in glyphs(data, at["cmap"]).items() if c >= 0x20}, ascent - descent


regular, height = advances(sys.argv[1])
bold, bold_height = advances(sys.argv[2])
if height != bold_height or set(regular) != set(bold):
    sys.exit("text_advances.py: the two faces differ in height or characters")
print("// Made by scripts/text_advances.py from Open Sans Regular and Semibold; do not edit by hand.")
print('#include "text_advances.hpp"\n\n#include <array>\n\nnamespace deixis::studies {\n\nnamespace {\n')
print("// clang-format off\nconstexpr auto table = std::to_array<TextAdvance>({")
items = [f"{{0x{c:x}, {regular[c]}, {bold[c]}}}," for c in sorted(regular)]
for i in range(0, len(items), 5):
    print("    " + " ".join(items[i : i + 5]))
print("});\n// clang-format on\n\n}  // namespace\n")
print(f"const int advance_units = {height};\nconst std::span<const TextAdvance> text_advances{{table}};")
print("\n}  // namespace deixis::studies")
