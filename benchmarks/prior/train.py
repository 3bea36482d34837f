"""Train the networks of the soft constraint `prior` on recordings of people, with PyTorch on two threads.

    python benchmarks/prior/train.py RECORDINGS.npz [-o models/prior.npz] [--steps 4000] [--networks 2] [--width 448]

RECORDINGS.npz contains clips at 30 frames per second of twelve bodies with ball joints in the order of `people.PARTS`:
`start` (C + 1,) the first frame of every clip; `root` (F, 3) the pelvis and `q` (F, 12, 4) the rotations of the bodies
relative to their parents, wxyz; and for every clip `off` (C, 12, 3), `wrist`, `toe` (C, 2, 3), the offsets of bodies
and their ends. All lengths are relative to the length of a leg. The weights are written as integers of 8 bits.

The networks are trained twice with the same steps: without every fourth block of four clips, to calibrate the expected
squared errors on these blocks, and on all clips.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
import torch
from torch import nn

from dynsplines.solver import quaternion as quat
from dynsplines.solver.penalty.motion import people

RATE = 30.0  # [1/s]
SHORTEST, LONGEST = 5, 45  # frames per segment
AT_ONCE, PHASES = 256, 2  # segments of a batch; pairs of frames of each segment
BALANCE = 0.75  # power of a clip's duration to which its share of the segments is proportional
BLOCK, HELD_OUT = 4, 4  # adjacent clips in a block; one in so many blocks is held out
HELD_OUT_SEGMENTS = 4096
UNPLACED = 0.2  # share of segments with keyframes that leave the position of the hips unspecified
RATE_OF_LEARNING, DECAY, DROPOUT, AVERAGED = 1.2e-3, 0.02, 0.1, 0.998
LOSS = {"turn": 1.0, "hand and ankle": 1.5, "toe": 0.15, "hips": 0.3, "speed": 3.0, "variance": 0.02}


class Recordings:
    """Frames of all clips and of their mirror images, with orientations in the world and hips above the ground."""

    def __init__(self, path: Path) -> None:
        data = np.load(path)
        sides, flip, other = people.SIDES, np.array([1.0, -1, 1, -1]), people.MIRRORED
        start = data["start"]
        turns = np.concatenate([data["q"], data["q"][:, other] * flip]).astype(float)
        for part, parent in enumerate(people.PARENTS):
            if part:
                turns[:, part] = quat.product(turns[:, parent], turns[:, part])
        self.turns = quat.normalise(turns)
        self.offsets = np.concatenate([data["off"], data["off"][:, other] * sides]).astype(float)
        tips = np.concatenate([data["wrist"], data["toe"]], axis=1).astype(float)
        self.tips = np.concatenate([tips, tips[:, [1, 0, 3, 2]] * sides])
        self.first = np.concatenate([start[:-1], start[:-1] + start[-1]])
        self.length = np.tile(np.diff(start), 2)
        self.block = np.tile(np.arange(start.size - 1) // BLOCK, 2)
        clip = np.repeat(np.arange(self.first.size), self.length)
        between = self.offsets[:, [6, 9]].mean(axis=1)
        self.offsets[:, [1, 6, 9]] -= between[:, None]
        root = np.concatenate([data["root"], data["root"] * sides]).astype(float)
        self.hips = root + quat.rotate(self.turns[:, 0], between[clip])

    @property
    def is_held_out(self) -> np.ndarray:
        """Whether clips are held out for the calibration, (2 C,)."""
        return self.block % HELD_OUT == HELD_OUT - 1

    def batch(
        self, rng: np.random.Generator, clips: np.ndarray, count: int
    ) -> tuple[people.Segments, np.ndarray, np.ndarray, np.ndarray]:
        """Return random segments of some clips, with their clips, and frames between their keyframes, as phases and
        indices."""

        def lengths() -> np.ndarray:
            wide = rng.integers(SHORTEST, LONGEST + 1, count)
            return np.where(rng.random(count) < 0.7, wide, rng.integers(8, 25, count))

        def beside(gap: np.ndarray) -> np.ndarray:
            near = (gap * rng.uniform(0.6, 1.6, count)).astype(int).clip(3, 60)
            choice = rng.random(count)
            return np.where(choice < 0.4, gap, np.where(choice < 0.7, lengths(), near))

        share = np.cumsum(clips * self.length**BALANCE)
        share /= share[-1]
        clip = np.searchsorted(share, rng.random(count)).clip(0, share.size - 1)
        gap = np.minimum(lengths(), self.length[clip] - 1)
        a = self.first[clip] + (rng.random(count) * (self.length[clip] - gap)).astype(int)
        b, end = a + gap, self.first[clip] + self.length[clip]
        before, after = a - beside(gap), b + beside(gap)
        is_known = np.stack([before >= self.first[clip], after < end], axis=1) & (rng.random((count, 2)) > 0.08)
        keys = np.stack([np.where(is_known[:, 0], before, a), a, b, np.where(is_known[:, 1], after, b)], axis=1)
        gaps = np.diff(keys, axis=1) / RATE * rng.uniform(0.8, 1.25, (count, 1))
        on_floor = rng.random(count) > 0.25
        is_placed = (rng.random((count, 4)) < 0.25) | (rng.random((count, 1)) > UNPLACED)
        segments = people.Segments(
            self.hips[keys], self.turns[keys], self.offsets[clip], self.tips[clip], gaps, is_known, is_placed, on_floor
        )
        first = (rng.random((count, PHASES)) * gap[:, None]).astype(int)
        frames = np.stack([first, first + 1], axis=2).reshape(count, -1)
        return segments, clip, frames / gap[:, None], a[:, None] + frames

    def examples(self, seed: int, clips: np.ndarray, count: int = AT_ONCE) -> Iterator[dict[str, torch.Tensor]]:
        """Yield batches as tensors, with all that does not depend on the network."""
        rng = np.random.default_rng(seed)
        while True:
            segments, clip, u, frames = self.batch(rng, clips, count)
            none = np.zeros((*u.shape, 13, 3))
            hips, turns = segments.poses(none, u)
            bends = segments.bends.copy()
            bends[:, :, 12] = quat.rotate(quat.conjugate(segments.heading)[:, None], bends[:, :, 12])
            joints, tips = people.places(self.turns[frames], self.offsets[clip][:, None], self.tips[clip][:, None])
            arrays = {
                "features": segments.features, "bends": bends, "sines": people.sines(u), "cubics": people.cubics(u),
                "hips": hips, "turns": turns, "heading": segments.heading[:, None], "true hips": self.hips[frames],
                "true turns": self.turns[frames], "offsets": self.offsets[clip][:, None],
                "tips": self.tips[clip][:, None],
                "true ends": np.concatenate([tips, joints[:, :, people.ANKLES]], axis=2)
                + self.hips[frames][:, :, None],
            }  # fmt: skip
            yield {name: torch.from_numpy(np.asarray(array, np.float32)) for name, array in arrays.items()}


class Network(nn.Module):
    """Layers with residual connections; `people.outputs_of` is the same in NumPy."""

    def __init__(self, mean: torch.Tensor, std: torch.Tensor, width: int, depth: int) -> None:
        super().__init__()
        sizes = [mean.numel(), *[width] * depth, 13 * people.OUTPUTS]
        self.layers = nn.ModuleList(nn.Linear(a, b) for a, b in pairwise(sizes))
        self.register_buffer("mean", mean)
        self.register_buffer("std", std)
        self.drop = nn.Dropout(DROPOUT)
        nn.init.zeros_(self.layers[-1].bias)
        self.layers[-1].weight.data *= 0.1

    def forward(self, features: torch.Tensor) -> torch.Tensor:
        x = self.drop((features - self.mean) / self.std)
        for i, layer in enumerate(self.layers[:-1]):
            y = nn.functional.silu(layer(x))
            x = y if i == 0 else x + y
        return self.layers[-1](self.drop(x)).reshape(len(x), 13, people.OUTPUTS)


def product(p: torch.Tensor, q: torch.Tensor) -> torch.Tensor:
    w, u, a, v = p[..., :1], p[..., 1:], q[..., :1], q[..., 1:]
    u, v = torch.broadcast_tensors(u, v)
    return torch.cat([w * a - (u * v).sum(-1, keepdim=True), w * v + a * u + torch.cross(u, v, dim=-1)], -1)


def rotated(q: torch.Tensor, v: torch.Tensor) -> torch.Tensor:
    u, v = torch.broadcast_tensors(q[..., 1:], v)
    t = 2 * torch.cross(u, v, dim=-1)
    return v + q[..., :1] * t + torch.cross(u, t, dim=-1)


def exponential(v: torch.Tensor) -> torch.Tensor:
    half = 0.5 * length(v)[..., None]
    return torch.cat([torch.cos(half), 0.5 * v * torch.sin(half) / half], -1)


def length(v: torch.Tensor) -> torch.Tensor:
    return torch.sqrt((v * v).sum(-1) + 1e-8)


def losses(outputs: torch.Tensor, e: dict[str, torch.Tensor]) -> dict[str, torch.Tensor]:
    """Return the means of errors [rad, leg lengths] by name."""
    amplitudes = outputs[..., : 3 * people.MODES].reshape(*outputs.shape[:2], people.MODES, 3)
    tangents = torch.sigmoid(outputs[..., -3:-1]).transpose(1, 2)[..., None] * e["bends"]
    change = torch.einsum("bpm,bjmc->bpjc", e["sines"], amplitudes)
    change = change + torch.einsum("bpt,btjc->bpjc", e["cubics"], tangents)
    hips = e["hips"] + rotated(e["heading"], change[:, :, 12])
    turns = product(e["turns"], exponential(change[:, :, :12]))
    joints = [hips]
    for part, parent in enumerate(people.PARENTS[1:], start=1):
        joints.append(joints[parent] + rotated(turns[:, :, parent], e["offsets"][:, :, part]))
    tips = [joints[part] + rotated(turns[:, :, part], e["tips"][:, :, k]) for k, part in enumerate(people.TIPS)]
    ends = torch.stack([*tips, *(joints[part] for part in people.ANKLES)], dim=2)
    conjugate = e["true turns"] * torch.tensor([1.0, -1, -1, -1])
    angle = 2 * length(product(conjugate, turns)[..., 1:])
    off, moved = length(ends - e["true ends"]), length(hips - e["true hips"])
    speeds, true_speeds = (x[:, 1::2] - x[:, ::2] for x in (ends, e["true ends"]))
    square = torch.cat([angle, moved[..., None]], dim=-1).detach().square().mean(dim=1)
    log = outputs[..., -1]
    return {
        "turn": angle.mean(),
        "hand and ankle": off[:, :, [0, 1, 4, 5]].mean(),
        "toe": off[:, :, 2:4].mean(),
        "hips": moved.mean(),
        "speed": length(speeds - true_speeds).mean(),
        "variance": (log + (square + 1e-5) * torch.exp(-log)).mean(),
    }


class Training:
    """A network with its optimiser, and the moving averages of its weights."""

    def __init__(self, network: Network) -> None:
        self.network = network
        self.averages = {name: value.clone() for name, value in network.state_dict().items()}
        self.optimiser = torch.optim.AdamW(network.parameters(), weight_decay=DECAY)

    def step(self, example: dict[str, torch.Tensor], progress: float, step: int) -> dict[str, float]:
        """Take a step, and return the losses by name; progress: from 0 to 1."""
        rate = RATE_OF_LEARNING * min(1, (step + 1) / 200) * (0.5 * (1 + np.cos(np.pi * progress)) + 0.005)
        for group in self.optimiser.param_groups:
            group["lr"] = rate
        by_name = losses(self.network(example["features"]), example)
        self.optimiser.zero_grad()
        torch.stack([LOSS[name] * loss for name, loss in by_name.items()]).sum().backward()
        nn.utils.clip_grad_norm_(self.network.parameters(), 1.0)
        self.optimiser.step()
        share = min(AVERAGED, step / (step + 20))
        for name, value in self.network.state_dict().items():
            self.averages[name].lerp_(value, 1 - share)
        return {name: loss.item() for name, loss in by_name.items()}

    @property
    def weights(self) -> dict[str, np.ndarray]:
        """The averages, by the names in `people.outputs_of`."""
        names = {name: name.removeprefix("layers.").removesuffix(".weight") for name in self.averages}
        return {short: self.averages[name].numpy() for name, short in names.items()}


def trained(
    recordings: Recordings, clips: np.ndarray, networks: int, steps: int, width: int, depth: int
) -> list[dict[str, np.ndarray]]:
    """Return the weights of networks that differ in their initial weights, trained on some clips."""
    torch.manual_seed(0)
    examples = recordings.examples(0, clips)
    first = torch.cat([next(examples)["features"] for _ in range(16)])
    trainings = [Training(Network(first.mean(0), first.std(0) + 0.02, width, depth)) for _ in range(networks)]
    began, history = perf_counter(), []
    for step, example in zip(range(steps), examples, strict=False):
        history += [training.step(example, step / steps, step) for training in trainings]
        if (step + 1) % 300 == 0:
            means = {name: round(float(np.mean([step_losses[name] for step_losses in history])), 4) for name in LOSS}
            print(f"step {step + 1}  {perf_counter() - began:.0f} s  {means}", flush=True)
            history = []
    return [training.weights for training in trainings]


def calibrated(
    networks: list[dict[str, np.ndarray]], recordings: Recordings, reference: list[dict[str, np.ndarray]]
) -> list[dict[str, np.ndarray]]:
    """Return networks whose expected squared errors are those of clips that are held out.

    The likelihood of the errors of `reference`, networks that were trained without these clips, determines a factor
    and a power of the variance of each part, and the array "calibration", see `Prior.of`.
    """
    segments, _, u, frames = recordings.batch(np.random.default_rng(1), recordings.is_held_out, HELD_OUT_SEGMENTS)
    prediction = people.Prediction.of(reference, segments, u)
    moved = np.linalg.norm(prediction.hips - recordings.hips[frames], axis=-1)
    difference = quat.product(quat.conjugate(recordings.turns[frames]), prediction.turns)
    angles = np.linalg.norm(quat.rotation_vector(difference), axis=-1)
    square = np.concatenate([angles, moved[..., None]], axis=-1) ** 2
    arrays = np.log(prediction.expected), np.log(segments.gaps[:, 1:2]), prediction.apart, square.mean(axis=1)
    log, log_gap, apart, square = (torch.from_numpy(array) for array in arrays)
    shift, others = (torch.tensor(x, dtype=torch.double, requires_grad=True) for x in ([0.0] * 13, [1.0, 0.0, 2.0]))
    optimiser = torch.optim.LBFGS([shift, others], max_iter=300, line_search_fn="strong_wolfe")

    def variances() -> torch.Tensor:
        return torch.exp(shift + others[0] * log + others[1] * log_gap) + torch.exp(others[2]) * apart

    def loss() -> torch.Tensor:
        optimiser.zero_grad()
        value = (variances().log() + square / variances()).mean()
        value.backward()
        return value

    optimiser.step(loss)
    factors, ratio = shift.detach().numpy(), (square / variances()).detach().numpy()
    power, of_gap, of_apart = others[0].item(), others[1].item(), others[2].exp().item()
    print(f"power {power:.2f}, factors {np.exp(factors).round(2).tolist()}, {of_gap:.2f}, {of_apart:.2f}")
    for name, key in (("duration", segments.gaps[:, 1]), ("disagreement", (apart / log.exp()).mean(dim=1).numpy())):
        quarters = [ratio[part].mean().round(2).item() for part in np.array_split(np.argsort(key), 4)]
        print(f"squared errors relative to expected ones, quarters by {name}: {quarters}")
    out = [{name: value.copy() for name, value in network.items()} for network in networks]
    for network in out:
        last = max(int(name) for name in network if name.isdecimal())
        rows = np.arange(13) * people.OUTPUTS + people.OUTPUTS - 1
        network[f"{last}"][rows] *= power
        network[f"{last}.bias"][rows] = network[f"{last}.bias"][rows] * power + factors
        network["calibration"] = np.array([of_gap, of_apart])
    return out


def quantised(networks: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    """Return the arrays of the file: matrices as integers of 8 bits with a scale for each row."""
    out: dict[str, np.ndarray] = {}
    for n, network in enumerate(networks):
        for name, value in network.items():
            if value.ndim == 2:
                scale = np.abs(value).max(axis=1) / 127
                out[f"{n}.{name}"] = np.round(value / scale[:, None]).astype(np.int8)
                out[f"{n}.{name}.scale"] = scale.astype(np.float32)
            else:
                out[f"{n}.{name}"] = value.astype(np.float32)
    return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("recordings", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=Path(__file__).parents[2] / "models" / "prior.npz")
    parser.add_argument("--steps", type=int, default=4000)
    parser.add_argument("--networks", type=int, default=2)
    parser.add_argument("--width", type=int, default=448)
    parser.add_argument("--depth", type=int, default=3)
    parser.add_argument("--threads", type=int, default=2)
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    recordings = Recordings(options.recordings)
    size = options.networks, options.steps, options.width, options.depth
    others = trained(recordings, ~recordings.is_held_out, *size)
    networks = calibrated(trained(recordings, np.ones_like(recordings.is_held_out), *size), recordings, others)
    arrays: dict[str, Any] = quantised(networks)
    np.savez_compressed(options.output, **arrays)
    print(f"{options.output}: {options.output.stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
