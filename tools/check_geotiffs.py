"""Reads GeoTIFFs that Tiepoint wrote by GDAL: python3 tools/check_geotiffs.py LIST.json

Each entry of the list has `name`, `file` and what Tiepoint says of it: `georeference` {origin, by_column, by_row}, `size`, `epsg` (null where the system is not
known), `values` (a raw file of its pixels), perhaps `colours` (the same in red, green, blue and alpha) and `photo`, by which the values are made again from a photograph: its grey values (raw), camera, pose
and heights; or `near`, a GeoTIFF of the same ground. Else it has `table` and `column`: a table of the middles of pixels with their values. Needs rasterio and scipy (pip install rasterio scipy). Each check names what was read; the first that fails
ends with status 1.
"""

import csv
import json
import sys

import numpy
import rasterio
from rasterio.transform import Affine
from scipy.ndimage import map_coordinates, maximum_filter, minimum_filter

# Places of pixels are the same to this part of a pixel.
PLACE_PX = 0.01
# What lies so near to nothing is not read (`EDGE` of src/orthophoto/emptiness.rs), and what has nothing about it as far shows nothing (`REACH`).
EDGE_PX = 8
REACH_PX = 4
# Interpolations of the same photograph differ by some grey values beside edges.
MEDIAN_GREY = 1.5
# Beside another picture of the same ground, with the errors of the orientation and of what leans.
NEAR_PX = 0.5


def check(right, message):
    print(("ok: " if right else "wrong: ") + message)
    if not right:
        sys.exit(1)


def place_of(georeference):
    (x, y), (a, d), (b, e) = (georeference[key] for key in ("origin", "by_column", "by_row"))
    return Affine(a, b, x, d, e, y)


def most_off(read, said, size):
    """The largest distance of a corner of the picture from where it should be, in px."""
    corners = [(column, row) for column in (0, size[0]) for row in (0, size[1])]
    return max(numpy.hypot(*numpy.subtract(~said @ (read @ corner), corner)) for corner in corners)


def shift(own, other, shown):
    """By how many px a picture lies off another one, by least squares: a shift, a gain and an offset of grey values."""
    down, right = numpy.gradient(other)
    inside = shown.copy()
    for axis in (0, 1):
        for step in (-2, -1, 1, 2):
            inside &= numpy.roll(shown, step, axis)
    design = numpy.stack([right[inside], down[inside], other[inside], numpy.ones(inside.sum())], axis=1)
    found, *_ = numpy.linalg.lstsq(design, own[inside], rcond=None)
    return -found[:2] / found[2]


def from_photo(photo, place, shape):
    """Grey values of a photograph without distortion at the middles of pixels of the ground, and where there are any."""
    with rasterio.open(photo["heights"]) as file:
        model, ground = file.read(1).astype(float), ~file.transform
    rows, columns = numpy.mgrid[: shape[0], : shape[1]] + 0.5
    x, y = place @ (columns, rows)
    column, row = ground @ (x, y)
    z = map_coordinates(model, [row - 0.5, column - 0.5], order=1, cval=numpy.nan)
    camera, pose = photo["camera"], photo["pose"]
    away = numpy.stack([x, y, z]) - numpy.array(pose["position"])[:, None, None]
    u, v, w = numpy.einsum("ij,jrc->irc", numpy.array(pose["rotation"]), away)
    at_x = camera["principal_point_px"][0] - camera["focal_px"] * u / w
    at_y = camera["principal_point_px"][1] + camera["focal_px"] * v / w
    grey = numpy.fromfile(photo["grey"], numpy.uint8).reshape(camera["height_px"], camera["width_px"]).astype(float)
    found = map_coordinates(grey, [numpy.nan_to_num(at_y, nan=-9) - 0.5, numpy.nan_to_num(at_x, nan=-9) - 0.5], order=3, cval=numpy.nan)
    return found, numpy.isfinite(found)


def on_grid(path, place, shape):
    """Values of another GeoTIFF at the middles of pixels, and where there are any."""
    with rasterio.open(path) as file:
        values, shown, ground = file.read(1).astype(float), file.dataset_mask() > 0, ~file.transform
    rows, columns = numpy.mgrid[: shape[0], : shape[1]] + 0.5
    column, row = ground @ (place @ (columns, rows))
    where = [row - 0.5, column - 0.5]
    return map_coordinates(values, where, order=1), map_coordinates(shown.astype(float), where, order=1) > 0.99


def check_file(entry):
    name = entry["name"]
    with rasterio.open(entry["file"]) as file:
        bands, shown, place, size = file.read(), file.dataset_mask() > 0, file.transform, [file.width, file.height]
        values = bands[0]
        code = file.crs.to_epsg() if file.crs else None
        kind = f"{file.count} {'band' if file.count == 1 else 'bands'} of {file.dtypes[0]}, {file.compression.value if file.compression else 'not compressed'}"
        tiles = f"tiles of {file.block_shapes[0][1]} x {file.block_shapes[0][0]} px" if file.profile["tiled"] else f"strips of {file.block_shapes[0][0]} rows"
        overviews, nodata = file.overviews(1), file.nodata
    check(size == entry["size"], f"{name}: {size[0]} x {size[1]} px, {kind}, {tiles}, {len(overviews)} overviews, no data {nodata}")
    off = most_off(place, place_of(entry["georeference"]), size)
    check(off <= PLACE_PX, f"{name}: corners {off:.1e} px off")
    check(code == entry["epsg"], f"{name}: system {'EPSG:' + str(code) if code else 'not named'}")
    said = numpy.fromfile(entry["values"], values.dtype).reshape(values.shape)
    is_said = numpy.isfinite(said) if values.dtype.kind == "f" else said > 0
    # Tiepoint takes what is narrower for shadows, and leaves out what lies beside nothing.
    wide = maximum_filter(minimum_filter(~shown, size=2 * REACH_PX + 1, mode="constant", cval=1), size=2 * REACH_PX + 1)
    beside = maximum_filter(~shown, size=2 * EDGE_PX + 1)
    wrong = (is_said & wide).sum() + (shown & ~is_said & ~beside).sum()
    check(wrong == 0, f"{name}: {shown.sum()} px are shown, {(~shown).sum()} are not, as is meant")
    both = shown & is_said
    if len(bands) == 1:
        check((values[both] == said[both]).all() and both.any(), f"{name}: {both.sum()} values are equal")
    if "colours" in entry:
        colours = numpy.fromfile(entry["colours"], numpy.uint8).reshape(*values.shape, 4)
        equal = all((bands[k % len(bands)][both] == colours[..., k][both]).all() for k in range(3))
        check(equal and (colours[..., 3] == 255 * is_said).all() and both.any(), f"{name}: {both.sum()} colours are equal, of {len(bands)} bands")
    if "photo" in entry:
        made, there = from_photo(entry["photo"], place, values.shape)
        both = there & shown
        right, down = shift(values.astype(float), numpy.nan_to_num(made), both)
        check(numpy.hypot(right, down) <= PLACE_PX, f"{name}: {right:+.4f} {down:+.4f} px off the photograph that is resampled there by its orientation")
        median = numpy.median(numpy.abs(values[both] - made[both]))
        check(median <= MEDIAN_GREY and both.sum() > 0.99 * shown.sum(), f"{name}: {median:.2f} grey values off it in the median of {both.sum()} px")
    if "near" in entry:
        other, there = on_grid(entry["near"], place, values.shape)
        right, down = shift(values.astype(float), other, there & shown)
        check(numpy.hypot(right, down) <= NEAR_PX, f"{name}: {right:+.3f} {down:+.3f} px off {entry['near_name']}")


def check_table(entry):
    name = entry["name"]
    with rasterio.open(entry["file"]) as file:
        values, shown, place = file.read(1), file.dataset_mask() > 0, ~file.transform
    with open(entry["table"], encoding="utf8") as table:
        rows = list(csv.DictReader(table))
    at = numpy.array([place @ (float(row["x"]), float(row["y"])) for row in rows]) - 0.5
    off = numpy.hypot(*(at - at.round()).T).max()
    check(off <= PLACE_PX, f"{name}: the {len(rows)} places of the table lie {off:.1e} px off the middles of pixels at most")
    column, row = at.round().astype(int).T
    said = numpy.array([float(line[entry["column"]] or "nan") for line in rows])
    known = numpy.isfinite(said)
    check((shown[row, column] == known).all(), f"{name}: {known.sum()} of them have a value in both")
    check(numpy.allclose(values[row, column][known], said[known], rtol=1e-6, atol=0), f"{name}: these are equal to single precision")
    shown[row, column] = False
    check(not values[shown].any(), f"{name}: nothing is shown elsewhere")


with open(sys.argv[1], encoding="utf8") as entries:
    for entry in json.load(entries):
        (check_table if "table" in entry else check_file)(entry)
