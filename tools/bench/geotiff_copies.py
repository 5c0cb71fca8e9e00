"""Copies a GeoTIFF by GDAL, moved into EPSG:25833: python3 tools/bench/geotiff_copies.py FILE COG TURNED

COG: a cloud optimised GeoTIFF, of tiles and overviews; TURNED: another one, whose rows run at an angle to the axes of the system. Needs rasterio.
"""

import sys

import rasterio
from rasterio.transform import Affine

CODE = "EPSG:25833"
SHIFT = (300_000, 5_000_000)
TURN_DEG = 25.0


def main(path, cog, turned):
    with rasterio.open(path) as file:
        values, place, dtype, nodata = file.read(), Affine.translation(*SHIFT) @ file.transform, file.dtypes[0], file.nodata
    given = dict(count=1, width=values.shape[2], height=values.shape[1], dtype=dtype, crs=CODE, nodata=nodata, compress="DEFLATE")
    with rasterio.open(cog, "w", driver="COG", blocksize=256, transform=place, **given) as file:
        file.write(values)
    about = Affine.rotation(TURN_DEG, SHIFT)
    with rasterio.open(turned, "w", driver="GTiff", tiled=True, blockxsize=256, blockysize=256, transform=about @ place, **given) as file:
        file.write(values)


main(*sys.argv[1:])
