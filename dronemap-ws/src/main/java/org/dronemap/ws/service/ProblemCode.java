package org.dronemap.ws.service;

import java.util.List;
import java.util.stream.Stream;

/**
 * Why exactly a request was not carried out, as a word for programs that never changes: one catalogue for all faces, an enum a
 * subject. {@code docs/problems.md} is written from it.
 */
public sealed interface ProblemCode
        permits AccessProblem,
                DroneProblem,
                OperationProblem,
                RequestProblem,
                ServerProblem,
                UnknownProblem,
                ValueProblem {
    ProblemEntry entry();

    /** Small letters with hyphens, such as {@code drone-unknown}. */
    default String word() {
        return entry().word();
    }

    default RejectionKind kind() {
        return entry().kind();
    }

    /** All of them, by subject. */
    static List<ProblemCode> all() {
        return Stream.<ProblemCode[]>of(
                        RequestProblem.values(),
                        ValueProblem.values(),
                        UnknownProblem.values(),
                        AccessProblem.values(),
                        DroneProblem.values(),
                        OperationProblem.values(),
                        ServerProblem.values())
                .flatMap(Stream::of)
                .toList();
    }
}
