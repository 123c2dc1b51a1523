#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""command_line_page.py DERMIS OUT.md   Writes the page of the command line from the manual page of the
program, without the options that docs/settings.md has. ./run docs puts it beside the other pages."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEAD = """# Command line

Made by `./run docs` from `dermis --man`. A command takes the options of its table,
[those of several commands](#options-of-several-commands), and [settings](settings.md). `--help` shows the
options that most people need, `--help-all` all. Installed programs have this as a manual page, with
completions for bash and zsh.
[Exit status](requirements.md#exit-status), [folders](requirements.md#folders).
"""


# Lists of words that are longer stand in the help text, too.
longest_type = 25


def plain(roff):
    text = re.sub(r"\\f[BIR]", "", roff)
    for coded, character in {"-": "-", "(aq": "'", "(ga": "`", "(ha": "^", "(ti": "~"}.items():
        text = text.replace("\\" + coded, character)
    return text.replace("\\&", "").replace("\\e", "\\")


def cell(text):
    return text.replace("|", "\\|")


def options_of(lines):
    """(names, type, help, default), and the title it stands under, of each paragraph ".TP"."""
    options, title, at = [], "", 0
    while at < len(lines):
        if lines[at].startswith(".I "):
            title = plain(lines[at][3:].strip('"'))
        at += 1
        if lines[at - 1] != ".TP":
            continue
        names = tuple(plain(n) for n in re.findall(r"\\fB(.*?)\\fR", lines[at]))
        kind = plain("".join(re.findall(r"\\fI(.*?)\\fR", lines[at])))
        words, at = [], at + 1
        while at < len(lines) and not lines[at].startswith("."):
            words.append(lines[at])
            at += 1
        default = ""
        if words and words[-1].startswith("(default: "):
            default = plain(words.pop())
        options.append(((names, kind, plain(" ".join(words)).strip(), default), title))
    return options


def commands_of(man):
    """Name -> options; and name -> what it does."""
    sections = re.split(r'^\.SH "?([^"\n]*)"?\n', man, flags=re.MULTILINE)
    by_title = dict(zip(sections[1::2], sections[2::2]))
    summary = dict(re.findall(r"^\.TP\n\.B (.*)\n(.*)$", by_title["COMMANDS"], flags=re.MULTILINE))
    begin = "OPTIONS OF DERMIS "
    found = {
        title.removeprefix(begin).lower(): options_of(text.split("\n"))
        for title, text in by_title.items()
        if title.startswith(begin)
    }
    return found, {plain(k): plain(v) for k, v in summary.items()}


def row_of(option):
    names, kind, help_text, default = option
    written = ", ".join(f"`{n}`" for n in names)
    if kind:
        written += f" `{cell(kind if len(kind) <= longest_type else kind.split('|')[0])}`"
    return f"{written} | {cell(help_text)}{' ' + cell(default) if default else ''}"


def page_of(man, settings):
    of_settings = set(re.findall(r"\| `(--[a-z-]+)` \|", settings))
    commands, summary = commands_of(man)
    users = {}
    for name, options in commands.items():
        for option, _ in options:
            users.setdefault(option, []).append(name)

    text = HEAD
    for name, options in commands.items():
        text += f"\n## {name}\n\n{summary[name][0].upper()}{summary[name][1:]}.\n"
        own = [o for o, _ in options if o[0][-1] not in of_settings and len(users[o]) == 1]
        if own:
            text += "\n| option | meaning |\n|---|---|\n"
            text += "".join(f"| {row_of(o)} |\n" for o in own)
        titles = list(dict.fromkeys(title for o, title in options if o[0][-1] in of_settings))
        if titles:
            text += f"\nSettings: {', '.join(titles)}.\n"

    text += "\n## Options of several commands\n\n| option | meaning | commands |\n|---|---|---|\n"
    for option, of in users.items():
        if len(of) > 1 and option[0][-1] not in of_settings:
            text += f"| {row_of(option)} | {', '.join(of)} |\n"
    return text


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    man = subprocess.run([sys.argv[1], "--man"], check=True, capture_output=True, text=True).stdout
    settings = (ROOT / "docs" / "settings.md").read_text(encoding="utf-8")
    pathlib.Path(sys.argv[2]).write_text(page_of(man, settings), encoding="utf-8")


main()
