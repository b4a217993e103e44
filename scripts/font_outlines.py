#!/usr/bin/env python3
"""Writes include/concino/render/detail/text/font_table.hpp from a TrueType file: the outlines of the characters that pictures need.

    scripts/font_outlines.py /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf > include/concino/render/detail/text/font_table.hpp
    scripts/font_outlines.py /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --license > LICENSE-font.txt

The table says how outlines are written.
"""
import struct
import sys

CHARACTERS = (
    list(range(0x20, 0x7F))  # ASCII
    + [c for c in range(0xA0, 0x100) if c != 0xAD]  # Latin-1, without the soft hyphen
    + [c for c in range(0x391, 0x3CA) if c != 0x3A2]  # Greek
    + [0x3D1, 0x3D5, 0x3F1, 0x3F5]  # the other theta, phi, rho, epsilon
    + [0x2010, 0x2013, 0x2014, 0x2018, 0x2019, 0x201C, 0x201D, 0x2020, 0x2022, 0x2026, 0x2030, 0x2032, 0x2033]  # punctuation
    + [0x2070, 0x2071] + list(range(0x2074, 0x208F))  # superscripts and subscripts
    + [0x20AC, 0x2126, 0x212B]  # euro, ohm, angstrom
    + [0x2190, 0x2191, 0x2192, 0x2193, 0x2194]  # arrows
    + [0x2202, 0x2206, 0x2207, 0x2208, 0x220F, 0x2211, 0x2212, 0x221A, 0x221D, 0x221E, 0x2225, 0x222B]  # mathematics
    + [0x2248, 0x2260, 0x2261, 0x2264, 0x2265, 0x226A, 0x226B, 0x27E8, 0x27E9]
)
EM = 1024  # units of the table


HEAD = r"""#pragma once

#include <cstdint>

namespace concino::detail {

/// A character. Its outline is a string of four characters for each point, 64 different ones in all: two numbers from
/// 0 to 4095, of two digits each, the characters after '#' without '?' and the backslash. Half of a number, minus
/// 1024, is the distance from the last point, in 1/1024 of the em. The last bit of the first number says whether the
/// point is on the curve, that of the second whether it ends its contour.
struct font_entry {
  std::uint32_t character;
  std::uint16_t advance;
  const char* outline;
};

// clang-format off"""


class Font:
    def __init__(self, data):
        self.data = data
        self.tables = {}
        for i in range(struct.unpack(">H", data[4:6])[0]):
            tag, _, offset, size = struct.unpack(">4sLLL", data[12 + 16 * i : 28 + 16 * i])
            self.tables[tag.decode()] = data[offset : offset + size]
        head = self.tables["head"]
        self.em = struct.unpack(">H", head[18:20])[0]
        long_offsets = struct.unpack(">h", head[50:52])[0]
        loca = self.tables["loca"]
        if long_offsets:
            self.loca = struct.unpack(">%dL" % (len(loca) // 4), loca)
        else:
            self.loca = [2 * x for x in struct.unpack(">%dH" % (len(loca) // 2), loca)]
        self.num_metrics = struct.unpack(">H", self.tables["hhea"][34:36])[0]
        self.glyph_of = self.read_cmap()

    def read_cmap(self):
        cmap = self.tables["cmap"]
        for i in range(struct.unpack(">H", cmap[2:4])[0]):
            start = struct.unpack(">L", cmap[8 + 8 * i : 12 + 8 * i])[0]
            if struct.unpack(">H", cmap[start : start + 2])[0] == 12:
                n = struct.unpack(">L", cmap[start + 12 : start + 16])[0]
                groups = [struct.unpack(">LLL", cmap[start + 16 + 12 * k : start + 28 + 12 * k]) for k in range(n)]
                return {c: glyph + c - first for first, last, glyph in groups for c in range(first, last + 1)}
        sys.exit("no character map of format 12")

    def advance(self, glyph):
        k = min(glyph, self.num_metrics - 1)
        return struct.unpack(">H", self.tables["hmtx"][4 * k : 4 * k + 2])[0]

    def contours(self, glyph):
        """Lists of (x, y, on the curve), in font units."""
        d = self.tables["glyf"][self.loca[glyph] : self.loca[glyph + 1]]
        if not d:
            return []
        n = struct.unpack(">h", d[:2])[0]
        return self.simple(d, n) if n >= 0 else self.composite(d)

    def composite(self, d):
        result, at, more = [], 10, True
        while more:
            flags, part = struct.unpack(">HH", d[at : at + 4])
            at += 4
            if not flags & 2:
                sys.exit("a part is placed by points")
            dx, dy = struct.unpack(">hh" if flags & 1 else ">bb", d[at : at + (4 if flags & 1 else 2)])
            at += 4 if flags & 1 else 2
            a, b, c, e = 1, 0, 0, 1
            if flags & 8:
                a = e = struct.unpack(">h", d[at : at + 2])[0] / 16384
                at += 2
            elif flags & 0x40:
                a, e = (x / 16384 for x in struct.unpack(">hh", d[at : at + 4]))
                at += 4
            elif flags & 0x80:
                a, b, c, e = (x / 16384 for x in struct.unpack(">hhhh", d[at : at + 8]))
                at += 8
            for contour in self.contours(part):
                moved = [(a * x + c * y + dx, b * x + e * y + dy, on) for x, y, on in contour]
                result.append(moved[::-1] if a * e - b * c < 0 else moved)
            more = flags & 0x20
        return result

    @staticmethod
    def simple(d, n):
        ends = struct.unpack(">%dH" % n, d[10 : 10 + 2 * n])
        at = 12 + 2 * n + struct.unpack(">H", d[10 + 2 * n : 12 + 2 * n])[0]
        flags = []
        while len(flags) <= ends[-1]:
            repeat = d[at + 1] if d[at] & 8 else 0
            flags += [d[at]] * (repeat + 1)
            at += 2 if d[at] & 8 else 1

        def coordinates(short, same):
            nonlocal at
            x, result = 0, []
            for f in flags:
                if f & short:
                    x += d[at] if f & same else -d[at]
                    at += 1
                elif not f & same:
                    x += struct.unpack(">h", d[at : at + 2])[0]
                    at += 2
                result.append(x)
            return result

        xs, ys = coordinates(2, 16), coordinates(4, 32)
        points = [(x, y, f & 1) for x, y, f in zip(xs, ys, flags)]
        starts = [0] + [e + 1 for e in ends[:-1]]
        return [points[a : b + 1] for a, b in zip(starts, ends)]

    def name(self, identifier):
        names = self.tables["name"]
        n, strings = struct.unpack(">HH", names[2:6])
        for i in range(n):
            platform, _, _, which, size, offset = struct.unpack(">6H", names[6 + 12 * i : 18 + 12 * i])
            if which == identifier and platform == 3:
                return names[strings + offset : strings + offset + size].decode("utf-16-be")
        sys.exit("no name %d" % identifier)


def digits(x):
    """Two characters of 64: those from '#' on, without '?' and the backslash."""
    return "".join(chr(35 + v + (35 + v >= 63) + (35 + v + (35 + v >= 63) >= 92)) for v in (x // 64, x % 64))


def encoded(contours, em):
    """Differences of points, halved often enough to fit; outer outlines counter-clockwise, which TrueType has the other way round."""
    x = y = 0
    text = ""
    for contour in sorted(contours, key=lambda c: c[-1][0]):
        scaled = [(round(px * EM / em), round(py * EM / em), on) for px, py, on in contour[::-1]]
        for k, (px, py, on) in enumerate(scaled):
            while max(abs(px - x), abs(py - y)) >= 1024:
                if k == 0:
                    sys.exit("a contour begins too far from the one before")
                mx, my = x + (px - x) // 2, y + (py - y) // 2
                text += digits((mx - x + 1024) * 2 + 1) + digits((my - y + 1024) * 2)
                x, y = mx, my
            text += digits((px - x + 1024) * 2 + on) + digits((py - y + 1024) * 2 + (k + 1 == len(scaled)))
            x, y = px, py
    return text


def main():
    font = Font(open(sys.argv[1], "rb").read())
    if "--license" in sys.argv:
        print("The outlines of characters in include/concino/render/detail/text/font_table.hpp are a part of the font DejaVu Sans,")
        print("under the name concino sans. This is the licence of DejaVu Sans.\n")
        print(font.name(13).replace("\r", ""))
        return
    print("// The outlines of the font concino sans; see font.hpp. Made by scripts/font_outlines.py from DejaVu Sans, whose\n// licence is LICENSE-font.txt:")
    print("// Copyright (c) 2003 by Bitstream, Inc. All Rights Reserved. Bitstream Vera is a trademark of Bitstream, Inc.")
    print("// Copyright (c) 2006 by Tavmjong Bah. All Rights Reserved. DejaVu changes are in public domain.")
    print(HEAD)
    print("inline constexpr font_entry font_entries[] = {")
    for c in sorted(CHARACTERS):
        glyph = font.glyph_of[c]
        text = encoded(font.contours(glyph), font.em)
        lines = ['"%s"' % text[i : i + 116] for i in range(0, max(len(text), 1), 116)]
        print("    {0x%x, %d, %s}," % (c, round(font.advance(glyph) * EM / font.em), ("\n      ").join(lines)))
    print("};\n// clang-format on\n\n}  // namespace concino::detail")


main()
