"""Makes large orthophotos of many kinds: python3 tools/bench/orthophoto_kinds.py OUT OWN

Of the orthophoto OWN, again and again, with a corner of which nothing is shown. Prints a line of JSON for each: its file, a part of it, and the files of the grey values and of the mask
that GDAL reads there. Needs rasterio (pip install rasterio).
"""

import json
import sys
from pathlib import Path

import numpy
import rasterio
from rasterio.enums import ColorInterp
from rasterio.shutil import copy
from rasterio.transform import Affine
from rasterio.windows import Window

SIDE = 6500
EMPTY = 3000
PART = Window(2400, 2800, 1200, 400)
COLOURS = [ColorInterp.red, ColorInterp.green, ColorInterp.blue]


def grey_of(bands):
    """Luma of Rec. 601 as the project has it; of one band of 12 bits its share of white."""
    if len(bands) == 1:
        return (bands[0].astype(int) * 255 + 2047) // 4095
    red, green, blue = (band.astype(int) for band in bands[:3])
    return (red * 4899 + green * 9617 + blue * 1868 + 8192) >> 14


def main(out, own_path):
    out = Path(out)
    with rasterio.open(own_path) as file:
        own = file.read(1)
    repeats = [-(-SIDE // length) for length in own.shape]
    ground = numpy.maximum(numpy.tile(own, repeats)[:SIDE, :SIDE], 1)
    shown = numpy.ones(ground.shape, bool)
    shown[:EMPTY, :EMPTY] = False
    colour = numpy.stack([ground, (ground * 0.9 + 12).astype(numpy.uint8), (ground * 0.7 + 30).astype(numpy.uint8)])
    alpha = numpy.concatenate([colour, (shown * 255).astype(numpy.uint8)[None]])
    twelve = numpy.where(shown, ground.astype(numpy.uint16) * 16 + 15, 65535).astype(numpy.uint16)[None]
    kinds = {
        "alpha, deflate, tiles": (alpha, dict(driver="GTiff", tiled=True, compress="DEFLATE", predictor=2)),
        "alpha, LZW, strips": (alpha, dict(driver="GTiff", compress="LZW", predictor=2)),
        "alpha, BigTIFF": (alpha, dict(driver="GTiff", tiled=True, compress="LZW", bigtiff="YES")),
        "colour, JPEG, YCbCr": (colour, dict(driver="COG", compress="JPEG")),
        "colour, JPEG, RGB": (colour, dict(driver="GTiff", tiled=True, compress="JPEG", photometric="RGB")),
        "12 of 16 bits, no data": (twelve, dict(driver="COG", compress="DEFLATE", nodata=65535)),
    }
    for name, (bands, options) in kinds.items():
        path = out / f"kind{list(kinds).index(name)}.tif"
        place = dict(width=SIDE, height=SIDE, count=len(bands), dtype=bands.dtype, crs="EPSG:25833", transform=Affine(0.2, 0, 3e5, 0, -0.2, 5e6))
        with rasterio.open(path, "w", **place, **options) as file:
            if len(bands) == 4:
                file.colorinterp = [*COLOURS, ColorInterp.alpha]
            file.write(bands)
        tell(name, path)
    masked = out / "masked.tif"
    copy(out / "kind0.tif", masked, driver="COG", compress="JPEG")
    tell("colour, JPEG, mask", masked)


def tell(name, path):
    with rasterio.open(path) as file:
        grey, mask = grey_of(file.read(window=PART)), file.dataset_mask(window=PART)
    files = [path.with_suffix(f".{kind}.raw") for kind in ("grey", "mask")]
    numpy.asarray(grey, numpy.uint8).tofile(files[0])
    (mask > 0).astype(numpy.uint8).tofile(files[1])
    part = dict(column=PART.col_off, row=PART.row_off, width=PART.width, height=PART.height)
    print(json.dumps(dict(name=name, file=str(path), part=part, grey=str(files[0]), mask=str(files[1]))))


main(*sys.argv[1:])
