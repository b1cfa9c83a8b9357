package org.dronemap.ws.stream;

import java.util.List;
import java.util.function.Function;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.AccessRule;
import org.dronemap.ws.access.AuditPolicy;
import org.dronemap.ws.access.RequestCost;

/** Access rule of a request on the WebSocket stream: who may send it, its cost and its audit record. */
public sealed interface StreamAccessRule<R> {
    /** {@code rest}: finds the rule of an operation of REST. */
    AccessRule of(R request, Function<String, AccessRule> rest);

    /** The ids of the operations of REST whose rules count. */
    List<String> operations();

    /** For people. */
    default String words() {
        return "Judged as in REST: " + String.join(", ", operations()) + ".";
    }

    /** The rule of the operation of REST that does the same. */
    record OfOperation<R>(String operation) implements StreamAccessRule<R> {
        @Override
        public AccessRule of(R request, Function<String, AccessRule> rest) {
            return rest.apply(operation);
        }

        @Override
        public List<String> operations() {
            return List.of(operation);
        }
    }

    /** The same, where the request says which of several operations that is. */
    record OfOneOf<R>(List<String> operations, Function<R, String> choice) implements StreamAccessRule<R> {
        public OfOneOf {
            operations = operations.stream().sorted().toList();
        }

        @Override
        public AccessRule of(R request, Function<String, AccessRule> rest) {
            return rest.apply(choice.apply(request));
        }
    }

    /** A rule of its own, for what REST does not have; {@code why} it has it not. */
    record StreamOnly<R>(AccessLevel from, RequestCost costs, AuditPolicy audit, String why)
            implements StreamAccessRule<R> {
        @Override
        public AccessRule of(R request, Function<String, AccessRule> rest) {
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
