package org.dronemap.core.parameter;

import java.util.List;

/** Content of a parameter file: values for the autopilot, and lines that are none, with the reason. */
public record ParameterFileContent(List<ParameterValue> values, List<LeftOut> leftOut) {
    public ParameterFileContent {
        values = List.copyOf(values);
        leftOut = List.copyOf(leftOut);
    }

    /**
     * A line that is not taken as it stands.
     *
     * @param line from 1
     * @param why a sentence
     */
    public record LeftOut(int line, String why) {}
}
