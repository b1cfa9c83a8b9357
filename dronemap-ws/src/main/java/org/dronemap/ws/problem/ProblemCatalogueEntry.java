package org.dronemap.ws.problem;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Catalogue entry of one problem code.
 *
 * @param word that programs read
 * @param kind the class of problems that it belongs to, and with it the status
 * @param meaning one line
 * @param example a sentence that is told with it
 * @param parameters told each time
 * @param optional told where they are known
 */
record ProblemCatalogueEntry(
        String word,
        RejectionKind kind,
        String meaning,
        String example,
        List<ProblemParameter> parameters,
        List<ProblemParameter> optional) {

    static ProblemCatalogueEntry of(String word, RejectionKind kind, String meaning, String example) {
        return new ProblemCatalogueEntry(word, kind, meaning, example, List.of(), List.of());
    }

    /** Always with these. */
    ProblemCatalogueEntry with(ProblemParameter... always) {
        return new ProblemCatalogueEntry(word, kind, meaning, example, List.of(always), optional);
    }

    /** With these where they are known. */
    ProblemCatalogueEntry maybe(ProblemParameter... sometimes) {
        return new ProblemCatalogueEntry(word, kind, meaning, example, parameters, List.of(sometimes));
    }

    /** Programs rely on what is declared: a refusal that tells more, less, or one thing twice is a fault of ours. */
    void check(List<ProblemParameter.Given> given) {
        Set<ProblemParameter> told = given.stream()
                .map(ProblemParameter.Given::parameter)
                .collect(Collectors.toCollection(LinkedHashSet::new));
        Set<ProblemParameter> known = new LinkedHashSet<>(parameters);
        known.addAll(optional);
        if (told.size() < given.size() || !known.containsAll(told) || !told.containsAll(parameters)) {
            throw new IllegalArgumentException(
                    "\"" + word + "\" is told with " + parameters + ", maybe " + optional + ", not with " + told);
        }
    }
}
