package org.dronemap.ws.access;

import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditText;
import org.dronemap.core.audit.AuditedCall;
import org.dronemap.ws.problem.ProblemView;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.reading.RecordAlternatives;
import org.jspecify.annotations.Nullable;

/** Adds details of a call to its audit record; only fields known to hold no secret are written. */
public final class AuditNotes {
    private static final int LONGEST_VALUE = 60;
    private static final Set<RejectionKind> NOT_UNDERSTOOD =
            EnumSet.of(RejectionKind.INVALID, RejectionKind.MALFORMED, RejectionKind.MEDIA_TYPE);

    /** Members of what clients send whose values may be read by all who read records. */
    private static final Set<String> TOLD = Set.of(
            "type",
            "id",
            "role",
            "state",
            "label",
            "operations",
            "drones",
            "drone",
            "days",
            "hours",
            "policy",
            "confirm",
            "reason",
            "user",
            "epoch",
            "altitude",
            "altitudeReference",
            "latitude",
            "longitude",
            "mode",
            "force",
            "degrees",
            "relay",
            "setting",
            "value",
            "onCloudLoss",
            "command",
            "onBreach",
            "kind");

    /** Where a name is one of things that are no secret; at the sign-in it may be a password in the wrong field. */
    private static final Set<String> NAMED = Set.of(
            "NewUser", "RenameRequest", "EnrolRequest", "MissionRequest", "ZoneFeature", "Properties", "SaveRequest");

    private AuditNotes() {}

    /** The call that this thread works for is turned away. Values that clients sent are not repeated. */
    public static void turnedAway(ProblemView problem) {
        AuditedCall.current().ifPresent(call -> {
            RejectionKind kind = kind(problem);
            call.turnedAway(
                    problem.status() >= 500 ? AuditOutcome.FAILED : AuditOutcome.REFUSED, reason(kind, problem));
            if (NOT_UNDERSTOOD.contains(kind)) {
                call.withoutTexts();
            }
        });
    }

    private static RejectionKind kind(ProblemView problem) {
        return Stream.of(RejectionKind.values())
                .filter(one -> problem.type().endsWith(":" + one.code()))
                .findFirst()
                .orElse(RejectionKind.BROKEN);
    }

    private static String reason(RejectionKind kind, ProblemView problem) {
        return switch (kind) {
            case INVALID -> kind.title() + ": " + AuditText.withoutSecrets(String.valueOf(problem.field())) + ".";
            case MALFORMED, MEDIA_TYPE -> kind.title() + ".";
            default -> AuditText.withoutSecrets(problem.detail());
        };
    }

    /** The call that this thread works for was sent this. */
    public static void sent(Object body) {
        AuditedCall.current().ifPresent(call -> call.parameters(summary(body, false), summary(body, true)));
    }

    /** {@code bare}: with the values of numbers and switches, but not of texts. */
    private static String summary(Object body, boolean bare) {
        if (!(body instanceof Record)) {
            return body instanceof byte[] bytes ? bytes.length + " bytes" : "";
        }
        return Stream.concat(
                        RecordAlternatives.discriminators(body.getClass()).entrySet().stream()
                                .map(told -> bare ? told.getKey() : told.getKey() + "=" + told.getValue()),
                        Stream.of(body.getClass().getRecordComponents())
                                .flatMap(component -> member(body, component, bare).stream()))
                .collect(Collectors.joining(", "));
    }

    private static Optional<String> member(Object body, RecordComponent component, boolean bare) {
        Object value = value(body, component.getAccessor());
        if (value == null) {
            return Optional.empty();
        }
        String name = component.getName();
        if (value instanceof Record inner) {
            String members = summary(inner, bare);
            return Optional.of(members.isEmpty() ? name : name + " (" + members + ")");
        }
        if (bare && !(value instanceof Number || value instanceof Boolean)) {
            return Optional.of(countOf(name, value));
        }
        if (name.equals("url")) {
            return Optional.of("url=" + address(String.valueOf(value)));
        }
        boolean named = name.equals("name") && NAMED.contains(body.getClass().getSimpleName());
        if (!named && !TOLD.contains(name)) {
            return Optional.of(countOf(name, value));
        }
        return Optional.of(name + "=" + withoutSecrets(String.valueOf(value)));
    }

    private static String countOf(String name, Object value) {
        return value instanceof Collection<?> many ? many.size() + " " + name : name;
    }

    /** Without what may stand in an address to prove who comes by it. */
    private static String address(String url) {
        return withoutSecrets(url.replaceFirst("[?#].*", "").replaceFirst("//[^/]*@", "//"));
    }

    /** Names with their values, for those that are there. */
    public static String summaryOf(@Nullable String... namesAndValues) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i + 1 < namesAndValues.length; i += 2) {
            String value = namesAndValues[i + 1];
            if (value != null) {
                text.append(text.isEmpty() ? "" : ", ")
                        .append(namesAndValues[i])
                        .append('=')
                        .append(withoutSecrets(value));
            }
        }
        return text.toString();
    }

    /** For people: short, and nothing in it that looks like a key. */
    public static String withoutSecrets(String value) {
        return AuditText.of(AuditText.withoutSecrets(value), LONGEST_VALUE);
    }

    private static @Nullable Object value(Object body, Method accessor) {
        try {
            accessor.setAccessible(true);
            return accessor.invoke(body);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException("a member of " + body.getClass() + " cannot be read", e);
        }
    }
}
