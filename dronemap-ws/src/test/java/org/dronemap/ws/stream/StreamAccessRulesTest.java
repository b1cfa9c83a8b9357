package org.dronemap.ws.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.dronemap.ws.access.HandlerCatalogue;
import org.dronemap.ws.access.RestOperation;
import org.dronemap.ws.control.ControlAction;
import org.dronemap.ws.reading.RecordAlternatives;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Each request of the stream is judged as an operation of REST is, or says why REST does not have it. */
class StreamAccessRulesTest {
    private static final List<String> OPERATIONS = HandlerCatalogue.all().stream()
            .map(RestOperation::id)
            .filter(Objects::nonNull)
            .toList();

    @ParameterizedTest
    @EnumSource
    void namesItsOperationsOrWhyThereAreNone(StreamRequestKind kind) {
        StreamAccessRule rule = StreamAccessRules.of(kind);
        if (rule instanceof StreamAccessRule.StreamOnly only) {
            assertThat(only.why()).matches("[A-Z].{20,}\\.");
        } else {
            assertThat(rule.operations()).isNotEmpty().isSubsetOf(OPERATIONS);
        }
    }

    @Test
    void namesAnOperationForEachActionOnControl() {
        StreamAccessRule.OfControl rule = (StreamAccessRule.OfControl) StreamAccessRules.of(StreamRequestKind.CONTROL);

        assertThat(rule.byAction().keySet()).containsExactlyInAnyOrder(ControlAction.values());
        assertThat(rule.operations()).doesNotHaveDuplicates();
    }

    /** Each record has its own kind, and is called as that is. */
    @Test
    void isOfEachRecordThatIsRead() {
        assertThat(RecordAlternatives.of(StreamRequest.class)
                        .orElseThrow()
                        .records()
                        .keySet())
                .containsExactlyElementsOf(Arrays.stream(StreamRequestKind.values())
                        .map(StreamRequestKind::word)
                        .collect(Collectors.toList()));
    }
}
