package org.dronemap.ws.place;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.jspecify.annotations.Nullable;

/**
 * Finds the name of the place nearest to a position, in a list that ships with the server (GeoNames, CC-BY 4.0). Any
 * thread.
 */
public final class PlaceNames {
    private static final String LIST = "/places.tsv.gz";
    private static final int ROWS = 181;
    private static final int COLUMNS = 360;
    private static final double AT_THE_PLACE_METERS = 1_000;
    private static final double FARTHEST_METERS = 300_000;
    private static final String[] DIRECTIONS = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};

    /** By cells of one degree; a cell's number is row and column. */
    private final Map<Integer, List<Place>> cells = new HashMap<>();

    private record Place(String label, Geodetic point) {}

    private PlaceNames() {}

    public static PlaceNames load() {
        PlaceNames names = new PlaceNames();
        try (InputStream list = PlaceNames.class.getResourceAsStream(LIST)) {
            if (list == null) {
                throw new IllegalStateException("the list of places is not in this build");
            }
            new BufferedReader(new InputStreamReader(new GZIPInputStream(list), StandardCharsets.UTF_8))
                    .lines()
                    .forEach(names::add);
        } catch (IOException e) {
            throw new UncheckedIOException("the list of places cannot be read", e);
        }
        return names;
    }

    private void add(String line) {
        String[] parts = line.split("\t", -1);
        Geodetic point = new Geodetic(Double.parseDouble(parts[2]), Double.parseDouble(parts[3]));
        cells.computeIfAbsent(cell(row(point), column(point)), key -> new ArrayList<>(2))
                .add(new Place(parts[0] + ", " + parts[1], point));
    }

    /** Such as "2 km NE of Zürich, CH"; null when no place is within 300 km. */
    public @Nullable String near(Geodetic point) {
        Place nearest = null;
        double least = FARTHEST_METERS;
        // a degree of latitude is 111 km; rings grow until no nearer place can lie outside
        for (int ring = 0; ring <= 3; ring++) {
            for (Place place : ring(point, ring)) {
                double distance = Geodesy.distanceMeters(place.point(), point);
                if (distance < least) {
                    least = distance;
                    nearest = place;
                }
            }
            if (least < ring * 111_000.0 * Math.cos(Math.toRadians(point.latitudeDegrees()))) {
                break;
            }
        }
        return nearest == null ? null : label(nearest, point, least);
    }

    private List<Place> ring(Geodetic point, int ring) {
        List<Place> found = new ArrayList<>();
        int row = row(point);
        int column = column(point);
        for (int north = -ring; north <= ring; north++) {
            int step = Math.abs(north) == ring || ring == 0 ? 1 : 2 * ring;
            for (int east = -ring; east <= ring; east += step) {
                int wrapped = Math.floorMod(column + east, COLUMNS);
                found.addAll(cells.getOrDefault(cell(row + north, wrapped), List.of()));
            }
        }
        return found;
    }

    private static String label(Place place, Geodetic point, double distance) {
        if (distance < AT_THE_PLACE_METERS) {
            return place.label();
        }
        double bearing = Geodesy.bearingDegrees(place.point(), point);
        String direction = DIRECTIONS[(int) Math.round(bearing / 45) % DIRECTIONS.length];
        return Math.round(distance / 1000) + " km " + direction + " of " + place.label();
    }

    private static int row(Geodetic point) {
        return (int) Math.floor(point.latitudeDegrees()) + 90;
    }

    private static int column(Geodetic point) {
        return Math.floorMod((int) Math.floor(point.longitudeDegrees()) + 180, COLUMNS);
    }

    private static int cell(int row, int column) {
        return row < 0 || row >= ROWS ? -1 : row * COLUMNS + column;
    }
}
