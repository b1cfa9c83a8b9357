package org.dronemap.ws.reading;

import com.fasterxml.jackson.annotation.Nulls;
import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RequestProblem;
import org.dronemap.ws.problem.ValueProblem;
import tools.jackson.core.JacksonException;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.core.exc.StreamReadException;
import tools.jackson.databind.DatabindException;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.exc.InvalidTypeIdException;
import tools.jackson.databind.exc.MismatchedInputException;
import tools.jackson.databind.exc.UnrecognizedPropertyException;
import tools.jackson.databind.json.JsonMapper;

/** Reads and writes JSON of all faces, and words what is wrong with JSON that a client sent. Any thread. */
public final class JsonCodec {
    /** What the parser tells programmers about itself. */
    private static final Pattern INTERNALS = Pattern.compile("( \\(start marker|: enable `).*");

    private static final Set<Class<?>> WHOLE = Set.of(int.class, Integer.class, long.class, Long.class);

    private final JsonMapper mapper;

    /** What a client wrote where no quotes are may be a password. */
    private static final Pattern LONG_TOKEN = Pattern.compile("'[^']{6,}'");

    public JsonCodec() {
        this(JsonMapper.builder()
                // a misspelt optional member must not be silently left out of a flight
                .enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
                // nor half a day be dropped
                .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
                .changeDefaultNullHandling(usual -> usual.withContentNulls(Nulls.FAIL))
                .build());
    }

    public JsonCodec(JsonMapper mapper) {
        this.mapper = mapper;
    }

    public JsonMapper mapper() {
        return mapper;
    }

    public <T> T read(String json, Class<T> type) {
        try {
            T value = mapper.readValue(json, type);
            if (value == null) {
                throw Rejection.of(RequestProblem.BODY_NOT_AN_OBJECT, "A JSON object is needed, not null.");
            }
            return value;
        } catch (JacksonException e) {
            throw rejection(e);
        }
    }

    /** A text at the top of what could not be read as a whole; empty: it has none there, or is no JSON. */
    public Optional<String> text(String json, String member) {
        try {
            return Optional.ofNullable(mapper.readTree(json).path(member).stringValue(null));
        } catch (JacksonException alreadyTold) {
            return Optional.empty();
        }
    }

    public String write(Object value) {
        return mapper.writeValueAsString(value);
    }

    /** What a client did wrong, with line and column, or with the field. */
    public static Rejection rejection(JacksonException e) {
        if (e instanceof UnrecognizedPropertyException unknown) {
            String known = known(unknown);
            String field = path(unknown);
            return new InvalidInput(
                    ValueProblem.MEMBER_UNKNOWN,
                    field,
                    known,
                    "There is no member \"" + field + "\" here; there are: " + known + ".");
        }
        if (e instanceof InvalidTypeIdException other) {
            RecordAlternatives all =
                    RecordAlternatives.of(other.getBaseType().getRawClass()).orElse(null);
            if (all != null) {
                return noneOf(all, other);
            }
        }
        if (e instanceof MismatchedInputException mismatch
                && !mismatch.getPath().isEmpty()) {
            String field = path(mismatch);
            String allowed = wanted(mismatch.getTargetType());
            return new InvalidInput(
                    ValueProblem.VALUE_MALFORMED, field, allowed, "\"" + field + "\" must be " + allowed + ".");
        }
        if (e instanceof StreamReadException && e.getLocation() != null) {
            TokenStreamLocation at = e.getLocation();
            return Rejection.of(
                    RequestProblem.JSON_UNREADABLE,
                    "This is not JSON: line " + at.getLineNr() + ", column " + at.getColumnNr() + ": "
                            + firstLine(e.getOriginalMessage()) + ".",
                    ProblemParameter.LINE.is(at.getLineNr()),
                    ProblemParameter.COLUMN.is(at.getColumnNr()));
        }
        return e instanceof StreamConstraintsException
                ? beyondLimits(e)
                : Rejection.of(RequestProblem.BODY_NOT_AN_OBJECT, "A JSON object is needed here.");
    }

    private static Rejection beyondLimits(JacksonException e) {
        TokenStreamLocation at = e.getLocation() == null ? TokenStreamLocation.NA : e.getLocation();
        return Rejection.of(
                RequestProblem.JSON_UNREADABLE,
                "This JSON cannot be read: it is nested too deeply, or has a name, a text or a number that is too long.",
                ProblemParameter.LINE.is(at.getLineNr()),
                ProblemParameter.COLUMN.is(at.getColumnNr()));
    }

    private static String known(UnrecognizedPropertyException unknown) {
        Stream<String> alternative = RecordAlternatives.discriminators(unknown.getReferringClass()).keySet().stream();
        Stream<Object> members =
                Optional.ofNullable(unknown.getKnownPropertyIds()).stream().flatMap(Collection::stream);
        return Stream.concat(alternative, members.map(String::valueOf)).collect(Collectors.joining(", "));
    }

    private static Rejection noneOf(RecordAlternatives all, InvalidTypeIdException other) {
        String at = path(other);
        String field = at.isEmpty() ? all.member() : at + "." + all.member();
        String allowed = all.allowed();
        String said = other.getTypeId();
        return said == null
                ? InvalidInput.missing(field, allowed)
                : InvalidInput.outside(ValueProblem.VALUE_NOT_ALLOWED, field, allowed, "\"" + said + "\"");
    }

    private static String firstLine(String text) {
        String line = text.lines().findFirst().orElse("it ends too soon");
        String trimmed =
                LONG_TOKEN.matcher(INTERNALS.matcher(line).replaceFirst("")).replaceAll("'…'");
        return trimmed.endsWith(".") ? trimmed.substring(0, trimmed.length() - 1) : trimmed;
    }

    private static String path(DatabindException e) {
        StringBuilder text = new StringBuilder();
        for (JacksonException.Reference step : e.getPath()) {
            if (step.getPropertyName() == null) {
                text.append('[').append(step.getIndex()).append(']');
            } else {
                text.append(text.isEmpty() ? "" : ".").append(step.getPropertyName());
            }
        }
        return text.toString();
    }

    private static String wanted(Class<?> type) {
        if (type == null) {
            return "of another type";
        }
        if (WHOLE.contains(type)) {
            return "a whole number";
        }
        if (Number.class.isAssignableFrom(type) || (type.isPrimitive() && type != boolean.class)) {
            return "a number";
        }
        if (type == Boolean.class || type == boolean.class) {
            return "true or false";
        }
        if (List.class.isAssignableFrom(type)) {
            return "a list";
        }
        if (type == Instant.class) {
            return "a time, like 2026-01-31T12:00:00Z";
        }
        return type == String.class ? "a text" : "an object";
    }
}
