#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""stack-10 as a program by numpy, or with --opencv by OpenCV's array functions.

stack10_numpy.py [--opencv] FOLDER OUTPUT: reads what patina_bench --write-stack10 wrote, writes
OUTPUT/base.png and OUTPUT/packed.png. Pillow reads for both, as OpenCV multiplies colour by alpha.
"""
import sys

import cv2
import numpy as np
from PIL import Image

ONE = np.float32(1)


def read(folder, name):
    image = np.asarray(Image.open(f"{folder}/{name}.tif"))
    return image.astype(np.float32) / np.float32(255)


def blended_numpy(mode, below, own):
    if mode == "normal":
        return own
    if mode == "multiply":
        return below * own
    if mode == "screen":
        return below + own - below * own
    if mode == "overlay":
        return np.where(below <= 0.5, 2 * below * own, 1 - 2 * (1 - below) * (1 - own))
    if mode == "add":
        return np.minimum(below + own, ONE)
    root = np.where(below <= 0.25, ((16 * below - 12) * below + 4) * below, np.sqrt(below))
    return np.where(own <= 0.5, below - (1 - 2 * own) * below * (1 - below),
                    below + (2 * own - 1) * (root - below))


def chosen(condition, yes, no):
    """Per component, as OpenCV has it: the condition is a mask of 0 and 255."""
    result = no.copy()
    cv2.copyTo(yes, condition, result)
    return result


def at_most(image, limit):
    return (image <= limit).astype(np.uint8)


def blended_opencv(mode, below, own):
    if mode == "normal":
        return own
    if mode == "multiply":
        return cv2.multiply(below, own)
    product = cv2.multiply(below, own)
    if mode == "screen":
        return cv2.subtract(cv2.add(below, own), product)
    if mode == "overlay":
        light = cv2.addWeighted(cv2.addWeighted(below, 2, own, 2, -1), 1, product, -2, 0)
        return chosen(at_most(below, 0.5), cv2.multiply(below, own, scale=2), light)
    if mode == "add":
        return cv2.threshold(cv2.add(below, own), 1, 1, cv2.THRESH_TRUNC)[1]
    square = cv2.multiply(below, below)
    cubic = cv2.addWeighted(cv2.multiply(square, below), 16, square, -12, 0)
    root = chosen(at_most(below, 0.25), cv2.addWeighted(cubic, 1, below, 4, 0), cv2.sqrt(below))
    twice = cv2.addWeighted(own, 2, own, 0, -1)
    dark = cv2.add(below, cv2.multiply(twice, cv2.subtract(below, square)))
    light = cv2.add(below, cv2.multiply(twice, cv2.subtract(root, below)))
    return chosen(at_most(own, 0.5), dark, light)


def laid_numpy(below, blended, cover):
    return below + cover * (blended - below)


def laid_opencv(below, blended, cover):
    return cv2.add(below, cv2.multiply(cover, cv2.subtract(blended, below)))


def composite(folder, blended, laid):
    color = read(folder, "base")
    rough = np.full(color.shape[:2], 128 / 255, np.float32)
    metal = np.zeros(color.shape[:2], np.float32)
    layers = [line.split() for line in open(f"{folder}/stack10.txt", encoding="ascii")]
    for i, (mode, opacity, metalness) in enumerate(layers):
        own = read(folder, f"color{i}")
        cover = own[:, :, 3] * read(folder, f"mask{i}") * np.float32(opacity)
        cover3 = cv2.merge([cover, cover, cover])
        own = np.ascontiguousarray(own[:, :, :3])
        color = laid(color, blended(mode, color, own), cover3)
        rough = laid(rough, read(folder, f"roughness{i}"), cover)
        metal = laid(metal, np.full_like(metal, float(metalness)), cover)
    return color, cv2.merge([np.ones_like(metal), rough, metal])


def write(path, image):
    bytes_of = (np.clip(image, 0, 1) * 255 + 0.5).astype(np.uint8)
    if not cv2.imwrite(path, cv2.cvtColor(bytes_of, cv2.COLOR_RGB2BGR)):
        sys.exit(f"cannot write {path}")


def main():
    arguments = sys.argv[1:]
    by_opencv = "--opencv" in arguments
    folder, output = [a for a in arguments if a != "--opencv"]
    cv2.setNumThreads(1)
    if by_opencv:
        base, packed = composite(folder, blended_opencv, laid_opencv)
    else:
        base, packed = composite(folder, blended_numpy, laid_numpy)
    write(f"{output}/base.png", base)
    write(f"{output}/packed.png", packed)


if __name__ == "__main__":
    main()
