package org.dronemap.ws.problem;

import java.util.List;
import java.util.stream.Stream;

/**
 * Stable code of why a request was refused, for programs; the same catalogue for REST, SOAP and the stream. {@code
 * docs/problems.md} is written from it.
 */
public sealed interface ProblemCode
        permits AccessProblem,
                CommandProblem,
                ControlProblem,
                DroneProblem,
                LinkSecurityProblem,
                ObjectionProblem,
                OperationProblem,
                RequestProblem,
                ServerProblem,
                UnfitProblem,
                NotFoundProblem,
                ValueProblem {
    ProblemCatalogueEntry entry();

    /** Small letters with hyphens, such as {@code drone-unknown}. */
    default String word() {
        return entry().word();
    }

    default RejectionKind kind() {
        return entry().kind();
    }

    /** All of them, by subject. */
    static List<ProblemCode> all() {
        return Stream.of(
                        List.of(RequestProblem.values()),
                        List.of(ValueProblem.values()),
                        List.of(NotFoundProblem.values()),
                        List.of(AccessProblem.values()),
                        CommandProblem.values(),
                        List.of(ControlProblem.values()),
                        List.of(DroneProblem.values()),
                        List.of(LinkSecurityProblem.values()),
                        List.of(OperationProblem.values()),
                        ObjectionProblem.values(),
                        UnfitProblem.values(),
                        List.of(ServerProblem.values()))
                .<ProblemCode>flatMap(List::stream)
                .toList();
    }
}
