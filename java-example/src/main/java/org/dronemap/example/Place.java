package org.dronemap.example;

/** A place over ground, in degrees. */
record Place(double latitude, double longitude) {
    private static final double EARTH_METERS = 6_371_000;
    private static final double NEAR_METERS = 2;

    /** The place so many metres further north. */
    Place north(double meters) {
        return new Place(latitude + Math.toDegrees(meters / EARTH_METERS), longitude);
    }

    /** Whether it is within 2 m of there; of what nobody knows, which is null, it is not. */
    boolean isNear(Double latitude, Double longitude) {
        if (latitude == null || longitude == null) {
            return false;
        }
        double north = Math.toRadians(latitude - this.latitude);
        double east = Math.toRadians(longitude - this.longitude) * Math.cos(Math.toRadians(latitude));
        return EARTH_METERS * Math.hypot(north, east) <= NEAR_METERS;
    }
}
