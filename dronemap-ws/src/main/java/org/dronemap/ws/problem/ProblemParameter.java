package org.dronemap.ws.problem;

/** Named and typed values that a problem response gives programs beside its sentence, such as a drone's id. */
public enum ProblemParameter {
    ADDRESS("address", Type.TEXT, "that was asked for"),
    ALLOWED("allowed", Type.TEXT, "what is allowed there, in words"),
    ALTITUDE("altitude", Type.NUMBER, "that is told, in metres above sea level"),
    CLOSED_BY("closedBy", Type.TEXT, "what of the access key, or of the rights, stands in the way"),
    COLUMN("column", Type.NUMBER, "where reading ended, from 1 on"),
    COMMAND("command", Type.TEXT, "id of the command"),
    COUNT("count", Type.NUMBER, "how many there are"),
    DRONE("drone", Type.TEXT, "id of the drone"),
    DRONES("drones", Type.NUMBER, "how many drones there are"),
    FIELD("field", Type.TEXT, "the member, element or parameter of the address"),
    HELD_SINCE("heldSince", Type.TEXT, "the time since when somebody has control"),
    HOLDER("holder", Type.TEXT, "who has control"),
    ID("id", Type.TEXT, "that was given"),
    LEAST("least", Type.NUMBER, "the least that is allowed"),
    LINE("line", Type.NUMBER, "where reading ended, from 1 on"),
    METHOD("method", Type.TEXT, "of HTTP"),
    MOST("most", Type.NUMBER, "the most that is allowed"),
    NAME("name", Type.TEXT, "that was given"),
    NEEDED("needed", Type.TEXT, "the least role that may do this"),
    ORIGIN("origin", Type.TEXT, "of the page"),
    OWNER("owner", Type.TEXT, "name of the user whose it is"),
    PROPOSAL("proposal", Type.NUMBER, "number of the proposal"),
    PROVIDER("provider", Type.TEXT, "what the other provider is called"),
    RETRY_AFTER_SECONDS("retryAfterSeconds", Type.NUMBER, "how long to wait"),
    ROLE("role", Type.TEXT, "that the asker has"),
    STATE("state", Type.TEXT, "of the waypoint: visited, cancelled or unserved"),
    UNIT("unit", Type.TEXT, "of least and most"),
    USERS("users", Type.NUMBER, "how many users there are"),
    WAYPOINT("waypoint", Type.TEXT, "id of the waypoint"),
    WHAT("what", Type.TEXT, "of which things");

    /** JSON type of a parameter's value: string or number. */
    public enum Type {
        TEXT("string"),
        NUMBER("number");

        private final String word;

        Type(String word) {
            this.word = word;
        }

        public String word() {
            return word;
        }
    }

    /** A parameter with its value, a text or a number as its type says. */
    public record Given(ProblemParameter parameter, Object value) {
        public Given {
            boolean fits = parameter.type == Type.TEXT ? value instanceof String : value instanceof Number;
            if (!fits) {
                throw new IllegalArgumentException(
                        "\"" + parameter.word + "\" is a " + parameter.type.word + ", not " + value.getClass());
            }
        }
    }

    private final String word;
    private final Type type;
    private final String meaning;

    ProblemParameter(String word, Type type, String meaning) {
        this.word = word;
        this.type = type;
        this.meaning = meaning;
    }

    public Given is(String value) {
        return new Given(this, ProblemView.shortened(value));
    }

    public Given is(long value) {
        return new Given(this, value);
    }

    /** A whole number is told as one, wherever it comes from. */
    public Given is(double value) {
        return value == Math.rint(value) ? is((long) value) : new Given(this, value);
    }

    public String word() {
        return word;
    }

    public Type type() {
        return type;
    }

    public String meaning() {
        return meaning;
    }
}
