package org.dronemap.ws.stream;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;
import org.dronemap.ws.control.ControlAction;

/** Access rule of a request on the WebSocket stream: who may send it, its cost and its audit record. */
public sealed interface StreamAccessRule {
    /** {@code rest}: finds the rule of an operation of REST. */
    AccessRule of(StreamRequest request, Function<String, AccessRule> rest);

    /** The ids of the operations of REST whose rules count. */
    List<String> operations();

    /** For people. */
    default String words() {
        return "Judged as in REST: " + String.join(", ", operations()) + ".";
    }

    /** The rule of the operation of REST that does the same. */
    record OfOperation(String operation) implements StreamAccessRule {
        @Override
        public AccessRule of(StreamRequest request, Function<String, AccessRule> rest) {
            return rest.apply(operation);
        }

        @Override
        public List<String> operations() {
            return List.of(operation);
        }
    }

    /** The same, where the action on control says which operation that is. */
    record OfControl(Map<ControlAction, String> byAction) implements StreamAccessRule {
        @Override
        public AccessRule of(StreamRequest request, Function<String, AccessRule> rest) {
            ControlAction action = ((StreamControlRequest) request).asked().action();
            return rest.apply(Objects.requireNonNull(byAction.get(action)));
        }

        @Override
        public List<String> operations() {
            return byAction.values().stream().sorted().toList();
        }
    }

    /** A rule of its own, for what REST does not have; {@code why} it has it not. */
    record StreamOnly(AccessLevel from, RequestCost costs, AuditPolicy audit, String why) implements StreamAccessRule {
        @Override
        public AccessRule of(StreamRequest request, Function<String, AccessRule> rest) {
            return new AccessRule(from, costs, audit, null);
        }

        @Override
        public List<String> operations() {
            return List.of();
        }

        @Override
        public String words() {
            return why;
        }
    }
}
