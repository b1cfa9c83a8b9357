package org.dronemap.ws.soap;

import java.lang.reflect.Field;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;
import org.apache.cxf.service.model.BindingOperationInfo;
import org.apache.cxf.service.model.MessagePartInfo;
import org.dronemap.ws.service.InvalidInput;
import org.dronemap.ws.service.Problem;
import org.dronemap.ws.service.ValueProblem;

/**
 * Turns away what the XML binding lets pass: elements that no operation knows (it tells of the first few of its life only),
 * and truth values that are none. What a client misspelt must not be silently left out of a flight.
 */
final class StrictElements extends AbstractPhaseInterceptor<Message> {
    private static final Set<String> TRUTH_VALUES = Set.of("true", "false", "1", "0");
    /** What has members of its own. */
    private static final Map<String, Class<?>> COMPOUND = Map.of(
            "waypoint", SoapWaypoint.class,
            "visit", SoapVisit.class,
            "objective", SoapObjective.class,
            "wind", SoapWind.class,
            "place", SoapPlace.class);

    StrictElements() {
        super(Phase.PRE_LOGICAL);
    }

    @Override
    public void handleMessage(Message message) {
        Whereabouts whereabouts = message.getExchange().get(Whereabouts.class);
        BindingOperationInfo operation = message.getExchange().getBindingOperationInfo();
        if (whereabouts == null || operation == null) {
            return;
        }
        Map<String, Class<?>> known = elementsOf(operation);
        whereabouts.seen().forEach((kind, seen) -> {
            Class<?> type = known.get(kind);
            if (type == null) {
                throw unknown(kind, seen.path(), known.keySet());
            }
            if (!seen.namespace().isEmpty()) {
                throw inNamespace(seen);
            }
            if (type == Boolean.class
                    && !TRUTH_VALUES.contains(seen.text().toString().strip())) {
                throw wrong(seen.path(), "true or false");
            }
        });
    }

    /** One for each parameter, in order. */
    static List<MessagePartInfo> partsOf(BindingOperationInfo operation) {
        BindingOperationInfo unwrapped = operation.isUnwrapped() || !operation.isUnwrappedCapable()
                ? operation
                : operation.getUnwrappedOperation();
        return unwrapped.getInput().getMessageParts();
    }

    private static Map<String, Class<?>> elementsOf(BindingOperationInfo operation) {
        Map<String, Class<?>> known = new LinkedHashMap<>();
        for (MessagePartInfo part : partsOf(operation)) {
            String name = part.getConcreteName().getLocalPart();
            known.put(name, part.getTypeClass());
            Class<?> compound = COMPOUND.get(name);
            if (compound != null) {
                for (Field member : compound.getDeclaredFields()) {
                    known.put(name + "." + member.getName(), member.getType());
                }
            }
        }
        return known;
    }

    private static Fault unknown(String kind, String field, Set<String> known) {
        String parent = kind.substring(0, kind.lastIndexOf('.') + 1);
        String allowed = known.stream()
                .filter(name -> name.startsWith(parent))
                .map(name -> name.substring(parent.length()))
                .filter(name -> name.indexOf('.') < 0)
                .reduce((one, other) -> one + ", " + other)
                .orElse("none");
        return FaultWords.fault(Problem.of(new InvalidInput(
                ValueProblem.MEMBER_UNKNOWN,
                field,
                allowed,
                "There is no element \"" + field + "\" here; there are: " + allowed + ".")));
    }

    private static Fault inNamespace(Whereabouts.Value seen) {
        String allowed = "an element without a namespace";
        return FaultWords.fault(Problem.of(new InvalidInput(
                ValueProblem.VALUE_MALFORMED,
                seen.path(),
                allowed,
                "\"" + seen.path() + "\" must be " + allowed + "; it is in " + seen.namespace() + ".")));
    }

    private static Fault wrong(String field, String allowed) {
        return FaultWords.fault(Problem.of(new InvalidInput(
                ValueProblem.VALUE_MALFORMED, field, allowed, "\"" + field + "\" must be " + allowed + ".")));
    }
}
