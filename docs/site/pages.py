"""What the site has beside the pages in docs/: README, CHANGELOG and CONTRIBUTING, the notebooks with their outputs, and the reference of the Rust library.

Links in documents are those of the repository. A link to a file that is no page gets a copy of the file in the site.
"""

from __future__ import annotations

import logging
import os
import posixpath
import re
import shutil
from pathlib import Path

import nbformat
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files
from mkdocs.structure.nav import Navigation
from mkdocs.structure.pages import Page
from nbconvert import MarkdownExporter

log = logging.getLogger("mkdocs.hooks.pages")

ROOT = Path(__file__).resolve().parents[2]
AT_ROOT = {"README.md": "index.md", "CHANGELOG.md": "CHANGELOG.md", "CONTRIBUTING.md": "CONTRIBUTING.md"}
NOTEBOOKS = "python/notebooks"
RUST = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "doc"
# what a block of code or a line of it contains is no link
LINK = re.compile(r"(?P<code>^ *```.*?^ *```|`[^`\n]+`)|(?P<before>!?\[[^\]]*\]\()(?P<to>[^)\s]+)\)", re.MULTILINE | re.DOTALL)

# where each file of the repository stands in the site, and what a page was made of
in_site: dict[str, str] = {}
made_of: dict[str, str] = {}


def on_files(files: Files, config: MkDocsConfig) -> Files:
    in_site.clear()
    for file in files:
        in_site[f"docs/{file.src_uri}"] = file.src_uri
    for name, at in AT_ROOT.items():
        files.append(File.generated(config, at, abs_src_path=str(ROOT / name)))
        in_site[name] = at
    for path in sorted((ROOT / NOTEBOOKS).glob("*.ipynb")):
        at = f"notebooks/{path.stem}.md"
        text, pictures = page_of(path)
        files.append(File.generated(config, at, content=text))
        for name, data in pictures.items():
            files.append(File.generated(config, f"notebooks/{name}", content=data))
        in_site[f"{NOTEBOOKS}/{path.name}"] = at
        # the notebook itself, to be run
        add(f"{NOTEBOOKS}/{path.name}", f"notebooks/{path.name}", files, config)
    made_of.update({at: name for name, at in in_site.items()})
    for page in [file for file in files if file.is_documentation_page()]:
        source = made_of.get(page.src_uri)
        if source and source.endswith(".md"):
            for to in targets((ROOT / source).read_text(encoding="utf-8"), source):
                if to not in in_site and (ROOT / to).is_file():
                    in_site[to] = f"files/{to}"
                    add(to, in_site[to], files, config)
    return files


def add(name: str, at: str, files: Files, config: MkDocsConfig) -> None:
    files.append(File.generated(config, at if not at.endswith(".md") else f"{at}.txt", abs_src_path=str(ROOT / name)))
    if at.endswith(".md"):
        in_site[name] = f"{at}.txt"


def targets(text: str, source: str) -> list[str]:
    """The files of the repository that a document links to."""
    found = [match["to"].partition("#")[0] for match in LINK.finditer(text) if match["to"] and "://" not in match["to"]]
    return [posixpath.normpath(posixpath.join(posixpath.dirname(source), to)) for to in found if to]


def page_of(path: Path) -> tuple[str, dict[str, bytes]]:
    """A notebook as Markdown, and its pictures."""
    notebook = nbformat.read(path, as_version=4)
    exporter = MarkdownExporter()
    text, resources = exporter.from_notebook_node(notebook, resources={"unique_key": path.stem, "output_files_dir": "."})
    pictures = {posixpath.basename(name): data for name, data in resources["outputs"].items()}
    # tables are HTML and have a frame of their own, in which they scroll
    text = re.sub(r"^<table.*?</table>$", lambda table: f'<div class="answer">{table[0]}</div>', text, flags=re.MULTILINE | re.DOTALL)
    title, _, rest = text.lstrip().partition("\n")
    return f"{title}\n\n[The notebook, to run it]({path.name})\n{rest}", pictures


def on_nav(nav: Navigation, config: MkDocsConfig, files: Files) -> Navigation:
    """Links to the Rust API in the site where cargo has written it."""
    if (RUST / "longdrive/index.html").exists():
        project = next(group for group in nav.items if group.title == "Project")
        next(entry for entry in project.children if entry.title == "Rust API").url = "rust/longdrive/index.html"
    return nav


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    source = made_of.get(page.file.src_uri)
    if source is None or not source.endswith(".md"):
        return markdown
    folder, here = posixpath.dirname(source), posixpath.dirname(page.file.src_uri)

    def link(match: re.Match[str]) -> str:
        if match["code"] or "://" in match["to"] or match["to"].startswith(("#", "mailto:")):
            return match[0]
        to, mark, anchor = match["to"].partition("#")
        name = posixpath.normpath(posixpath.join(folder, to))
        if name in in_site:
            return f"{match['before']}{posixpath.relpath(in_site[name], here or '.')}{mark}{anchor})"
        if (ROOT / name).is_dir():
            # a folder has no page: its name stands alone
            return f"{match['before'].removesuffix('](').removeprefix('[')} (`{name}`)"
        raise PluginError(f"{source} links to {match['to']}, and there is no {name}")

    return LINK.sub(link, markdown)


def on_post_build(config: MkDocsConfig) -> None:
    if (RUST / "longdrive/index.html").exists():
        shutil.copytree(RUST, Path(config.site_dir) / "rust", dirs_exist_ok=True, ignore=shutil.ignore_patterns(".lock"))
    else:
        log.info("the Rust API is linked to docs.rs: 'cargo doc --no-deps' has not been run")
