package org.dronemap.ws.problem;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.dronemap.core.virtual.UnfitCode;

/** Problem code of why a drone cannot serve a virtual drone or a follow, shown beside that drone in answers. */
record UnfitProblem(UnfitCode reason) implements ProblemCode {
    /** Requests and commands are refused for these, too: they have the word already. */
    private static final Set<UnfitCode> OF_OTHERS = EnumSet.of(
            UnfitCode.CONTACT_NOT_GOOD,
            UnfitCode.LINK_FALLING,
            UnfitCode.NOT_AT_REST,
            UnfitCode.CAPABILITY_MISSING,
            UnfitCode.POSITION_UNKNOWN,
            UnfitCode.HOME_UNKNOWN,
            UnfitCode.BATTERY_UNKNOWN);

    static List<UnfitProblem> values() {
        return Arrays.stream(UnfitCode.values())
                .filter(reason -> !OF_OTHERS.contains(reason))
                .map(UnfitProblem::new)
                .toList();
    }

    @Override
    public ProblemCatalogueEntry entry() {
        return ProblemCatalogueEntry.of(reason.word(), RejectionKind.CONFLICT, reason.meaning(), reason.example());
    }
}
