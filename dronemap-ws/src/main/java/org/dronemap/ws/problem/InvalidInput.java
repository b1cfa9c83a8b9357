package org.dronemap.ws.problem;

import java.util.ArrayList;
import java.util.List;

/** Rejection of a request with an unusable value: names the field and what is allowed there. */
public final class InvalidInput extends Rejection {
    private static final long serialVersionUID = 1L;

    private final String field;
    private final String allowed;

    /** {@code parameters} beside field and allowed. */
    public InvalidInput(
            ValueProblem code, String field, String allowed, String sentence, ProblemParameter.Given... parameters) {
        super(code, sentence, withField(field, allowed, parameters));
        this.field = field;
        this.allowed = allowed;
    }

    private static List<ProblemParameter.Given> withField(
            String field, String allowed, ProblemParameter.Given... parameters) {
        List<ProblemParameter.Given> all = new ArrayList<>();
        all.add(ProblemParameter.FIELD.is(field));
        all.add(ProblemParameter.ALLOWED.is(allowed));
        all.addAll(List.of(parameters));
        return all;
    }

    public static InvalidInput missing(String field, String allowed) {
        return new InvalidInput(
                ValueProblem.VALUE_MISSING,
                field,
                allowed,
                "\"" + field + "\" is missing; it must be " + allowed + ".");
    }

    public static InvalidInput outside(
            ValueProblem code, String field, String allowed, Object value, ProblemParameter.Given... parameters) {
        return new InvalidInput(
                code, field, allowed, "\"" + field + "\" must be " + allowed + ", not " + value + ".", parameters);
    }

    /** Places too far apart, or zones with too many corners. */
    public static InvalidInput unplannable(IllegalArgumentException why) {
        return new InvalidInput(
                ValueProblem.PLACES_UNPLANNABLE,
                "waypoints",
                "places that can be planned",
                "This cannot be planned: " + why.getMessage() + ".");
    }

    /** The same of a field that stands within another one; the sentence names it as before. */
    public InvalidInput within(String above) {
        ProblemParameter.Given[] others = parameters().stream()
                .filter(given ->
                        given.parameter() != ProblemParameter.FIELD && given.parameter() != ProblemParameter.ALLOWED)
                .toArray(ProblemParameter.Given[]::new);
        return new InvalidInput((ValueProblem) code(), above + field, allowed, sentence(), others);
    }

    public String field() {
        return field;
    }

    public String allowed() {
        return allowed;
    }
}
