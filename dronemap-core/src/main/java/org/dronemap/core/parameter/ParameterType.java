package org.dronemap.core.parameter;

/** Numeric type of a vehicle parameter, as in MAVLink. */
public enum ParameterType {
    UINT8(1, false, 0, 255),
    INT8(2, false, -128, 127),
    UINT16(3, false, 0, 65_535),
    INT16(4, false, -32_768, 32_767),
    UINT32(5, false, 0, 4_294_967_295.0),
    INT32(6, false, Integer.MIN_VALUE, Integer.MAX_VALUE),
    UINT64(7, false, 0, 1.8446744073709552E19),
    INT64(8, false, -9.223372036854776E18, 9.223372036854776E18),
    REAL32(9, true, -Float.MAX_VALUE, Float.MAX_VALUE),
    REAL64(10, true, -Double.MAX_VALUE, Double.MAX_VALUE);

    private final int fileNumber;
    private final boolean decimal;
    private final double least;
    private final double most;

    ParameterType(int fileNumber, boolean decimal, double least, double most) {
        this.fileNumber = fileNumber;
        this.decimal = decimal;
        this.least = least;
        this.most = most;
    }

    /** What ground stations call this type in their files. */
    public int fileNumber() {
        return fileNumber;
    }

    /** True when it may have digits after the point. */
    public boolean decimal() {
        return decimal;
    }

    public double least() {
        return least;
    }

    public double most() {
        return most;
    }

    /** The number as a parameter of this type can hold it. */
    public double held(double value) {
        return this == REAL32 ? (float) value : decimal ? value : Math.rint(value);
    }

    /** Whether it can hold the number at all, up to the precision of its type. */
    public boolean holds(double value) {
        return value >= least && value <= most && (decimal || value == Math.rint(value));
    }
}
