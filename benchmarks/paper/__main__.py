"""The command `python -m benchmarks.paper`: the paper's claims claim by claim, or its figures."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

from dynsplines.__main__ import main as run_command

Seeds = Annotated[int | None, typer.Option(help="sets of keyframes [default: 20]", min=1)]
Folder = Annotated[Path | None, typer.Option(help="draw the paper's figures into this folder instead", metavar="DIR")]
AsJson = Annotated[bool, typer.Option("--json", help="print JSON")]

app = typer.Typer(add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)


@app.command()
def paper(seeds: Seeds = None, figures: Folder = None, as_json: AsJson = False) -> None:
    """Reproduce the paper's claims on fixed sets: verdict, claim, paper, here; or draw its figures."""
    if figures is not None:
        _draw_figures(figures, seeds, as_json=as_json)
        return
    from rich.console import Console

    from dynsplines import solving
    from dynsplines.measure.report import report
    from dynsplines.picture.graphics import do_without
    from dynsplines.system.progress import Progress

    from . import claim, clips, study

    do_without()
    with Progress() as progress:
        claims = study.run(seeds or study.SETS, progress)
        clip = clips.loaded("run_and_step")
        claims += study.clip_claims(report(clip, solving.solve(clip, progress)))
    if as_json:
        print(json.dumps(claim.as_json(claims), indent=2))
    else:
        Console(highlight=False).print(claim.table(claims))


def _draw_figures(folder: Path, seeds: int | None, *, as_json: bool) -> None:
    from dynsplines.errors import UserError
    from dynsplines.picture.graphics import choose
    from dynsplines.system.progress import Progress

    if seeds is not None:
        raise UserError("--seeds: figures are of the clips run_and_step and tumble, not of sets; leave it out")
    graphics = choose()
    from .figures import drawing

    drawing.check_folder(folder)
    with Progress() as progress:
        progress.report(graphics.line)
        drawn = drawing.draw(folder, graphics, progress)
        for figure in drawn:
            progress.report(f"wrote {figure.file}")
    if as_json:
        print(json.dumps([figure.as_json for figure in drawn], indent=2))


def main() -> None:
    """Run the command as `dynsplines` runs its own: the same answers to bad input and to signals."""

    def command() -> None:
        from dynsplines.system.exit_status import run

        run(lambda: app(prog_name="python -m benchmarks.paper", standalone_mode=False))

    run_command(command)


if __name__ == "__main__":
    main()
