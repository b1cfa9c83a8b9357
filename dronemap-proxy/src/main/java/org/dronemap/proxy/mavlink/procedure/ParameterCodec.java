package org.dronemap.proxy.mavlink.procedure;

import java.util.Arrays;
import org.dronemap.core.parameter.Parameter;
import org.dronemap.core.parameter.ParameterType;
import org.dronemap.mavlink.message.ParamValue;

/**
 * Encodes and decodes parameter values in the float that carries them, as ArduPilot (value) or PX4 (bits) does.
 *
 * @param bytewise whole numbers travel as their bits (PX4), not as their value (ArduPilot)
 */
public record ParameterCodec(boolean bytewise) {
    private static final ParameterType[] TYPES = ParameterType.values();

    /** MAV_PARAM_TYPE; what is not known is taken for a decimal. */
    public static ParameterType type(int number) {
        return Arrays.stream(TYPES)
                .filter(type -> number(type) == number)
                .findFirst()
                .orElse(ParameterType.REAL32);
    }

    /** MAV_PARAM_TYPE. */
    public static int number(ParameterType type) {
        return switch (type) {
            case UINT8 -> 1;
            case INT8 -> 2;
            case UINT16 -> 3;
            case INT16 -> 4;
            case UINT32 -> 5;
            case INT32 -> 6;
            case UINT64 -> 7;
            case INT64 -> 8;
            case REAL32 -> 9;
            case REAL64 -> 10;
        };
    }

    public Parameter decode(ParamValue message) {
        ParameterType type = type(message.paramType());
        return new Parameter(message.paramId(), type, decode(type, message.paramValue()));
    }

    /** What that number of the wire means. */
    public double decode(ParameterType type, float raw) {
        if (!bytewise || type.decimal()) {
            return type.decimal() ? raw : Math.rint(raw);
        }
        int bits = Float.floatToRawIntBits(raw);
        return switch (type) {
            case UINT8 -> bits & 0xFF;
            case INT8 -> (byte) bits;
            case UINT16 -> bits & 0xFFFF;
            case INT16 -> (short) bits;
            case UINT32, UINT64 -> Integer.toUnsignedLong(bits);
            default -> bits;
        };
    }

    /** As the wire carries it. */
    public float encode(ParameterType type, double value) {
        return bytewise && !type.decimal() ? Float.intBitsToFloat((int) (long) value) : (float) value;
    }

    /** What the vehicle holds after it was told that value: a float in between may have rounded it. */
    double afterWire(ParameterType type, double value) {
        return decode(type, encode(type, type.held(value)));
    }
}
