"""Makes an orthophoto of many pixels: python3 tools/bench/large_orthophoto.py OUT SIDE OWN OTHER [COMPRESSION]

In its middle is the orthophoto OWN, about it the orthophoto OTHER again and again, turned and mirrored, so that no place but the middle shows the
ground of OWN. Written as cloud optimised GeoTIFF (tiles, overviews) by GDAL; needs rasterio (pip install rasterio).
"""

import sys

import numpy
import rasterio
from rasterio.transform import Affine


def main(out, side, own_path, other_path, compression="JPEG"):
    side = int(side)
    with rasterio.open(own_path) as own_file, rasterio.open(other_path) as other_file:
        own, other, own_place = own_file.read(1), other_file.read(1), own_file.transform
    ground = numpy.zeros((side, side), numpy.uint8)
    height, width = other.shape
    for row in range(0, side, height):
        for column in range(0, side, width):
            flips = (row // height + column // width) % 4
            piece = other[:: -1 if flips & 1 else 1, :: -1 if flips & 2 else 1]
            ground[row : row + height, column : column + width] = piece[: side - row, : side - column]
    top, left = ((side - length) // 2 for length in own.shape)
    ground[top : top + own.shape[0], left : left + own.shape[1]] = own
    place = own_place @ Affine.translation(-left, -top)
    # Some colour: red, green and blue differ, as in a photograph.
    bands = numpy.stack([ground, (ground * 0.9 + 12).astype(numpy.uint8), (ground * 0.7 + 30).astype(numpy.uint8)])
    profile = dict(driver="COG", width=side, height=side, count=3, dtype="uint8", crs="EPSG:25833", transform=place, compress=compression)
    if compression == "JPEG":
        profile["quality"] = 85
    with rasterio.open(out, "w", **profile) as file:
        file.write(bands)


main(*sys.argv[1:])
