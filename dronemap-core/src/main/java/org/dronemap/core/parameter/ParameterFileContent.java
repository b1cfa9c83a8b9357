package org.dronemap.core.parameter;

import java.util.List;

/** Content of a parameter file: values for the autopilot, and lines that are none, with the reason. */
public record ParameterFileContent(List<ParameterValue> values, List<LeftOut> leftOut) {
    public ParameterFileContent {
        values = List.copyOf(values);
        leftOut = List.copyOf(leftOut);
    }

    /** Kinds of reasons for which a line is not taken as it stands. */
    public enum Reason {
        /** It is for a gimbal, a camera or the like. */
        OTHER_COMPONENT,
        /** It is for another vehicle than the first lines are. */
        OTHER_VEHICLE,
        /** It tells a program to do something, which is not done. */
        INSTRUCTION,
        /** It is no name with a value, or the value is none. */
        MALFORMED,
        /** Its name comes more than once, with another value. */
        REPEATED
    }

    /**
     * A line that is not taken as it stands.
     *
     * @param line from 1
     * @param why a sentence
     */
    public record LeftOut(int line, Reason reason, String why) {}
}
