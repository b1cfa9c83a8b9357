package org.dronemap.core.parameter;

/** One parameter of a vehicle as the vehicle reports it: name, type and value. */
public record Parameter(String name, ParameterType type, double value) {
    public Parameter withValue(double newValue) {
        return new Parameter(name, type, newValue);
    }

    /** The value as people write it: whole numbers without a point, others as short as their type can tell apart. */
    public String text() {
        return text(type, value);
    }

    static String text(ParameterType type, double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e15) {
            return Long.toString((long) value);
        }
        return type == ParameterType.REAL64 ? Double.toString(value) : Float.toString((float) value);
    }
}
