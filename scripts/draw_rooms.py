#!/usr/bin/env python3
"""Writes the picture of the rooms into docs/architecture.md and their list, docs/rooms.md, from the link lists in the
   CMakeLists.txt.
   scripts/draw_rooms.py           writes them
   scripts/draw_rooms.py --check   fails if the pages differ"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURE_PAGE = ROOT / "docs" / "architecture.md"
LIST_PAGE = ROOT / "docs" / "rooms.md"
BEGIN, END = "<!-- rooms: made by scripts/draw_rooms.py -->\n", "<!-- end of rooms -->\n"
MODULES = ["motion", "physics", "learning", "speech", "assets", "studies", "results", "renderer", "server", "app"]


def rooms_of(module):
    """{room: (main header, [rooms it may use])} in the order of the link lists."""
    text = (ROOT / module / "CMakeLists.txt").read_text()
    text = re.sub(r"#.*", "", text)
    variables = {name: value.split() for name, value in re.findall(r"set\((\w+) ((?:\w+/\w+ ?)+)\)", text)}
    found = {}
    for call in re.findall(r"add_room\(([^)]*)\)", text):
        words = [w for word in call.split() for w in (variables.get(word[2:-1], []) if word[0] == "$" else [word])]
        main = words[words.index("MAIN") + 1]
        found[words[0]] = (main, [w for w in words if re.fullmatch(r"[a-z_]+/[a-z_]+", w)])
    return found


def purpose(module, room, main):
    """The first sentence of the main header's opening comment."""
    header = ROOT / module / room / "include" / module / room / main
    comment = []
    for line in header.read_text().splitlines():
        if not line.startswith("//"):
            break
        comment.append(line[2:].strip())
    text = " ".join(filter(None, comment))
    if not text:
        sys.exit(f"{header}: has no opening comment that says what the room is for")
    end = re.search(r"[.:](?= [A-Z]|$)", text)
    return text[: end.start()] + "." if end else text


def within(found, module):
    """Arrows inside a module, without those that follow from others."""
    uses = {room: {u.split("/")[1] for u in use if u.startswith(module + "/")} for room, (_, use) in found.items()}

    def reach(room):
        out = set()
        for other in uses[room]:
            out |= {other} | reach(other)
        return out

    return [(room, other) for room in uses for other in sorted(uses[room])
            if not any(other in reach(third) for third in uses[room] if third != other)]


def picture(modules):
    out = ["```mermaid", "flowchart BT"]
    for module, found in modules.items():
        out.append(f"  subgraph {module}")
        out += [f"    {module}.{room}[{room}]" for room in found]
        out += [f"    {module}.{room} --> {module}.{other}" for room, other in within(found, module)]
        out.append("  end")
    arrows = {m: {u.split("/")[0] for _, use in found.values() for u in use} - {m} for m, found in modules.items()}
    for module in MODULES:
        for other in sorted(arrows[module]):
            if not any(other in arrows.get(third, ()) for third in arrows[module]):
                out.append(f"  {module} ==> {other}")
    return "\n".join(out + ["```", ""])


def listing(modules):
    out = ["# The rooms", "", "Made by `scripts/draw_rooms.py`. Each may also use `core`; [architecture](architecture.md) "
           "says what a room is.", ""]
    for module, found in modules.items():
        out += [f"**{module}/**", "", "| room | what it is for | may use |", "|---|---|---|"]
        for room, (main, use) in found.items():
            names = ", ".join(u.split("/")[1] if u.startswith(module + "/") else u for u in use) or "–"
            out.append(f"| [`{room}`](../{module}/{room}) | {purpose(module, room, main)} | {names} |")
        out.append("")
    return "\n".join(out)


def main():
    modules = {module: rooms_of(module) for module in MODULES}
    text = PICTURE_PAGE.read_text()
    before, rest = text.split(BEGIN)
    pages = {PICTURE_PAGE: before + BEGIN + picture(modules) + END + rest.split(END)[1], LIST_PAGE: listing(modules)}
    for page, new in pages.items():
        if sys.argv[1:] != ["--check"]:
            page.write_text(new)
        elif not page.exists() or page.read_text() != new:
            sys.exit(f"docs/{page.name} does not show the rooms as they are linked: run scripts/draw_rooms.py")


main()
