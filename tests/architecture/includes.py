#!/usr/bin/env python3
"""Draws which folders of plugin/ include which, and fails on a circle.

usage: includes.py PLUGIN_FOLDER [--dot FILE]

Checks that no files include each other in a circle, that no folders do, and that the layers include downward only.
Prints every folder with the folders it includes; --dot writes the same as a graph for Graphviz:
    tests/architecture/includes.py plugin --dot includes.dot && dot -Tsvg includes.dot -o assets/charts/includes.svg
"""
import argparse
import pathlib
import re
import sys

# From the bottom up: a layer includes itself and those before it, and no others.
LAYERS = ["core", "geometry", "io", "fracture", "stress_model", "bullet", "cli"]
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)


def includes_of_files(plugin):
    """File -> files of the tree that it includes, all as paths from `plugin`; and the includes that lead nowhere."""
    files = sorted(p for p in plugin.rglob("*") if p.suffix in (".h", ".cpp"))
    graph, unknown = {}, []
    for path in files:
        name = path.relative_to(plugin).as_posix()
        targets = INCLUDE.findall(path.read_text())
        graph[name] = sorted(t for t in targets if (plugin / t).is_file())
        unknown += [f"{name} includes \"{t}\", which is no path from {plugin.name}/" for t in targets
                    if not (plugin / t).is_file()]
    return graph, unknown


def includes_of_folders(files):
    graph = {}
    for name, targets in files.items():
        folder = name.rpartition("/")[0]
        others = {t.rpartition("/")[0] for t in targets} - {folder}
        graph.setdefault(folder, set()).update(others)
    return {folder: sorted(others) for folder, others in sorted(graph.items())}


def find_circle(graph):
    """The nodes of one circle, first and last the same; empty if there is none."""
    done, path = set(), []

    def visit(node):
        if node in path:
            return path[path.index(node):] + [node]
        if node in done:
            return []
        path.append(node)
        for target in graph.get(node, []):
            circle = visit(target)
            if circle:
                return circle
        path.pop()
        done.add(node)
        return []

    for node in graph:
        circle = visit(node)
        if circle:
            return circle
    return []


def upward_includes(files):
    wrong = []
    for name, targets in files.items():
        layer = name.split("/")[0]
        for target in targets:
            other = target.split("/")[0]
            if layer not in LAYERS or other not in LAYERS:
                wrong.append(f"{name} or {target} is in no known layer ({', '.join(LAYERS)})")
            elif LAYERS.index(other) > LAYERS.index(layer):
                wrong.append(f"{name} includes {target}, which lies above it")
    return wrong


def dot_of(folders):
    lines = ["digraph includes {", "  rankdir=TB; compound=true;",
             '  node [shape=box, style="rounded,filled", fillcolor=white, fontname="sans-serif", fontsize=11];',
             '  edge [color="#666666", arrowsize=0.6];']
    for layer in reversed(LAYERS):
        lines.append(f'  subgraph "cluster_{layer}" {{ label="{layer}"; fontname="sans-serif"; style="rounded,filled";'
                     ' color="#dddddd"; fillcolor="#f4f4f4";')
        for folder in folders:
            if folder.split("/")[0] == layer:
                lines.append(f'    "{folder}" [label="{folder.partition("/")[2] or folder}"];')
        lines.append("  }")
    lines += [f'  "{folder}" -> "{target}";' for folder, targets in folders.items() for target in targets]
    return "\n".join(lines + ["}", ""])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("plugin", type=pathlib.Path)
    parser.add_argument("--dot", type=pathlib.Path)
    arguments = parser.parse_args()

    files, troubles = includes_of_files(arguments.plugin)
    if not files:
        sys.exit(f"{arguments.plugin} holds no sources")
    folders = includes_of_folders(files)
    for folder, targets in folders.items():
        print(f"{folder} -> {', '.join(targets) or 'nothing'}")
    print(f"{len(folders)} folders, {sum(map(len, folders.values()))} arrows between them")

    troubles += upward_includes(files)
    for kind, graph in (("files", files), ("folders", folders)):
        circle = find_circle(graph)
        if circle:
            troubles.append(f"These {kind} include each other in a circle: {' -> '.join(circle)}")
    if arguments.dot:
        arguments.dot.write_text(dot_of(folders))
    if troubles:
        sys.exit("\n".join(troubles))


if __name__ == "__main__":
    main()
