"""Notebooks with their stored output as pages: NAME.md beside each, its figures in pictures/.

    python3 to_markdown.py           writes all of this folder
    python3 to_markdown.py --check   fails where a page is not what its notebook says
"""
import argparse
import base64
import sys
from pathlib import Path

import nbformat

HERE = Path(__file__).resolve().parent


def page_of(path):
    """The text of a page and its pictures by name."""
    parts, pictures = [], {}
    for cell in nbformat.read(path, as_version=4).cells:
        if cell.cell_type == "markdown":
            parts.append(cell.source)
            continue
        parts.append(f"```python\n{cell.source}\n```")
        for output in cell.outputs:
            data = output.get("data", {})
            if "image/png" in data:
                name = f"pictures/{path.stem}_{len(pictures) + 1}.png"
                pictures[name] = base64.b64decode(data["image/png"])
                parts.append(f"![figure {len(pictures)}]({name})")
            else:
                text = output.get("text") or data.get("text/plain", "")
                parts.append(f"```text\n{text.rstrip()}\n```")
    made = f"(Made from [{path.name}]({path.name}) by `python3 to_markdown.py`.)"
    return "\n\n".join([*parts, made]) + "\n", pictures


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--check", action="store_true")
    check, stale = arguments.parse_args().check, []
    for path in sorted(HERE.glob("*.ipynb")):
        text, pictures = page_of(path)
        files = {path.with_suffix(".md"): text.encode(),
                 **{HERE / name: data for name, data in pictures.items()}}
        for file, data in files.items():
            if check and (not file.is_file() or file.read_bytes() != data):
                stale.append(file.name)
            elif not check:
                file.parent.mkdir(exist_ok=True)
                file.write_bytes(data)
    if stale:
        sys.exit(f"not what the notebooks say: {', '.join(stale)}; python3 to_markdown.py")


if __name__ == "__main__":
    main()
