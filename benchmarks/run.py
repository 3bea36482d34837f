"""Every comparison of the README in one command, written as markdown and as JSON.

    python benchmarks/run.py [--only NAME ...] [--quick] [-o DIR]

Rules: both sides in one process and in turn, medians, one thread, building and compiling shown apart, failures of
for all programs counted. A section that is run again replaces its results in DIR and leaves the others.
"""

from __future__ import annotations

import pinned  # isort: skip  # before anything that imports NumPy

import argparse
import importlib
import json
import os
import platform
import time
import traceback
from dataclasses import asdict
from importlib import metadata
from pathlib import Path
from typing import Any

import report
from bench import Effort, Section
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

SECTIONS = (
    "evaluation", "runner39", "quaternions", "shooting", "uneven", "barr", "subdivision", "length", "clip", "perturbed",
    "posing", "recordings", "earning", "inbetweening", "rendering", "batch", "studio", "soak",
)  # fmt: skip
PACKAGES = ("numpy", "scipy", "mujoco", "nlopt", "imageio", "av", "interpolatepy", "casadi", "distributed")


def versions() -> dict[str, str]:
    """Python, every package that takes part, and the threads."""
    versions_by_name = {"python": platform.python_version()}
    for name in PACKAGES:
        try:
            versions_by_name[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            versions_by_name[name] = "not installed"
    return versions_by_name | {"threads": "1 (" + ", ".join(pinned.THREADS) + ")"}


def machine() -> str:
    """The processor and how busy it is."""
    model = platform.processor() or platform.machine()
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.is_file():
        names = [line.split(":")[1].strip() for line in cpuinfo.read_text().splitlines() if "model name" in line]
        model = names[0] if names else model
    return f"{model}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}"


def measured(name: str, effort: Effort) -> dict[str, Any]:
    """One section, with when and how it was measured; a failure is a result too."""
    begin, load = time.perf_counter(), machine()
    try:
        section = importlib.import_module(name).measure(effort)
    except Exception as error:
        traceback.print_exc()
        words = f"{type(error).__name__}: {' '.join(str(error).split())}"
        section = Section(name, ("result",), [(f"this section failed: {words}",)])
    fields = asdict(section)
    for target, present in zip(fields["targets"], section.targets, strict=True):
        target["met"] = present.met
    return fields | {
        "date": time.strftime("%Y-%m-%d %H:%M"),
        "seconds": round(time.perf_counter() - begin, 1),
        "quick": effort.quick,
        "machine": load,
        "versions": versions(),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description="comparisons with other tools, as a table")
    parser.add_argument(
        "--only", nargs="+", choices=SECTIONS, default=SECTIONS, metavar="NAME", help=" ".join(SECTIONS)
    )
    parser.add_argument("--quick", action="store_true", help="few sets and repeats; no figures to quote")
    parser.add_argument("-o", "--output", type=Path, default=Path(__file__).parent / "results", metavar="DIR")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    target = arguments.output / "results.json"
    results: dict[str, Any] = json.loads(target.read_text(encoding="utf-8")) if target.is_file() else {}
    console = Console(stderr=True, highlight=False)
    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[note]}"), TimeElapsedColumn())
    with Progress(*columns, console=console) as bars:
        task = bars.add_task("", total=len(arguments.only), note="")
        for name in (name for name in SECTIONS if name in arguments.only):
            bars.update(task, description=name, note="")

            def print_note(note: str) -> None:
                bars.update(task, note=note)

            results[name] = measured(name, Effort(arguments.quick, print_note))
            bars.advance(task)
            ordered = {key: results[key] for key in SECTIONS if key in results}
            report.write(ordered, arguments.output)
            console.print(report.section_text(name, results[name]), markup=False, soft_wrap=True)


if __name__ == "__main__":
    main()
