"""The list of commands; each stands in a file of its name, imported when it is called."""

from __future__ import annotations

import shutil
from collections.abc import Sequence
from importlib import import_module

import click

#: Columns of a terminal from which on an option's words stand beside it.
NARROW = 60

#: Command -> what it does, as the list of commands says it.
COMMANDS = {
    "robots": "List the arms that ship.",
    "show": "Show an arm and how it is solved.",
    "fk": "From joints to the pose of the tool.",
    "ik": "From a pose, or a file of poses, to every solution.",
    "path": "Follow straight lines with one branch.",
    "route": "The best way along a path that leaves something free.",
    "time": "Time a path within limits.",
    "program": "Time a program, draw it, and write it for a controller.",
    "animate": "Write a motion as a moving picture.",
    "clear": "Prove that a path touches nothing.",
    "report": "Write everything about an arm on one page.",
    "map": "Fill a box with answers: what the arm reaches.",
    "calibrate": "Fit an arm to what was measured.",
    "code": "Write an arm's solver in another language.",
    "verify": "Compare an arm with an independent toolbox.",
    "check": "Judge the claims someone makes about an arm.",
    "workbench": "Open the workbench in the browser.",
    "tour": "Run a whole study and write it up.",
}


class Help(click.HelpFormatter):
    """Help that fits a narrow terminal too: an option's words stand beneath it where they have no room beside it."""

    def __init__(self, indent_increment: int = 2, width: int | None = None, max_width: int | None = None) -> None:
        columns = shutil.get_terminal_size().columns
        super().__init__(indent_increment, columns - 2 if width is None and columns < NARROW else width, max_width)

    def write_dl(self, rows: Sequence[tuple[str, str]], col_max: int = 30, col_spacing: int = 2) -> None:
        """Write a list of terms and their words."""
        if self.width + 2 >= NARROW:
            super().write_dl(rows, col_max, col_spacing)
            return
        for term, words in rows:
            for text, more in ((term, 0), (words, self.indent_increment)):
                indent = " " * (self.current_indent + more)
                self.write(click.wrap_text(text, self.width, indent, indent) + "\n")


class Context(click.Context):
    """A call whose help is written so."""

    formatter_class = Help


class Commands(click.Group):
    """The group of all commands."""

    context_class = Context

    def list_commands(self, ctx: click.Context) -> list[str]:
        """Return their names in the order in which one meets them."""
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """Import a command."""
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = import_module(f"pieper.cli.{cmd_name}").command
        command.context_class = Context
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list without importing any."""
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command that was typed, or say which one was probably meant."""
        name = args[0]
        if not name.startswith("-") and name not in COMMANDS and not ctx.resilient_parsing:
            import difflib

            near = difflib.get_close_matches(name.lower(), COMMANDS, n=2, cutoff=0.5)
            near = near or [known for known in COMMANDS if name and known.startswith(name.lower())]
            hint = f" Did you mean {' or '.join(near)}?" if near else ""
            raise click.UsageError(f"There is no command {name!r}.{hint}", ctx)
        return super().resolve_command(ctx, args)


def _version(context: click.Context, _option: click.Parameter, wanted: bool) -> None:
    if wanted and not context.resilient_parsing:
        import pieper

        click.echo(f"pieper {pieper.__version__}")
        context.exit()


@click.group(cls=Commands, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.option(
    "--version", is_flag=True, is_eager=True, expose_value=False, callback=_version, help="Print the version."
)
def app() -> None:
    """Kinematics of serial arms: every inverse solution of a pose, verified, labelled and followed along paths.

    Degrees and millimetres unless said otherwise. ARM is a name of the catalogue (see `pieper robots`) or a part of one
    that only one arm has, or a robot file.

    Exit status: 0 done, 1 no solution, 2 misuse.
    """
