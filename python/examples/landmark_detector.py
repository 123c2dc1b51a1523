# SPDX-License-Identifier: MIT
"""Trains a small detector of 70 landmarks on a data set, and measures it on people whom it has not seen."""

import argparse
import io
import json
import tarfile
from pathlib import Path

import numpy as np
import numpy.typing as npt
import torch
from PIL import Image
from torch import nn

Array = npt.NDArray[np.float32]


def samples(folder: Path, split: str) -> tuple[Array, Array]:
    """Pictures (N, H, W), grey, of mean 0 and deviation 1 each; landmarks (N, 70, 2), pixels."""
    pictures: list[Array] = []
    points: list[Array] = []
    for shard in sorted(folder.glob(f"{split}-*.tar")):
        with tarfile.open(shard) as tar:
            for member in tar:
                file = tar.extractfile(member)
                assert file is not None
                name = member.name.partition(".")[2]
                if name == "png":
                    grey = np.asarray(Image.open(io.BytesIO(file.read())).convert("L"), np.float32)
                    pictures.append((grey - grey.mean()) / (grey.std() + 1))
                elif name == "landmarks.json":
                    points.append(np.array(json.load(file)["points"], np.float32)[:, :2])
    return np.stack(pictures), np.stack(points)


def network(height: int, width: int) -> nn.Sequential:
    layers: list[nn.Module] = []
    channels = [1, 16, 32, 64, 64]
    for before, after in zip(channels, channels[1:], strict=False):
        layers += [nn.Conv2d(before, after, 3, stride=2, padding=1), nn.BatchNorm2d(after), nn.ReLU()]
    cells = -(-height // 16) * -(-width // 16)
    return nn.Sequential(*layers, nn.Flatten(), nn.Dropout(0.2), nn.Linear(64 * cells, 140))


def error_px(found: Array, true: Array) -> float:
    return float(np.linalg.norm(found - true, axis=-1).mean())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="a data set with the label landmarks")
    parser.add_argument("--epochs", type=int, default=40)
    options = parser.parse_args()
    torch.manual_seed(1)
    torch.set_num_threads(1)  # a network so small gains nothing by more, and loses where others work

    pictures, points = samples(options.folder, "train")
    of_others, points_of_others = samples(options.folder, "test")
    mean = points.mean(axis=0)
    scale = float(points.std(axis=0).mean())
    inputs = torch.from_numpy(pictures)[:, None]
    targets = torch.from_numpy((points - mean) / scale).flatten(1)

    model = network(*pictures.shape[1:])
    optimiser = torch.optim.Adam(model.parameters(), 2e-3)
    batch = 32
    steps = options.epochs * -(-len(inputs) // batch)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, 4e-3, total_steps=steps)
    for _ in range(options.epochs):
        for chosen in torch.randperm(len(inputs)).split(batch):
            optimiser.zero_grad()
            loss = nn.functional.smooth_l1_loss(model(inputs[chosen]), targets[chosen])
            loss.backward()
            optimiser.step()
            schedule.step()

    model.eval()

    def found(grey: Array) -> Array:
        with torch.no_grad():
            offsets: Array = model(torch.from_numpy(grey)[:, None]).numpy()
        there: Array = offsets.reshape(-1, *mean.shape) * scale + mean
        return there

    print(f"people of the training: {error_px(found(pictures), points):.2f} px")
    print(f"other people: {error_px(found(of_others), points_of_others):.2f} px")
    print(f"other people, by the mean shape: {error_px(mean, points_of_others):.2f} px")


if __name__ == "__main__":
    main()
