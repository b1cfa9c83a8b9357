package org.dronemap.ws.recovery;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.cognitive.operation.recovery.RecoveryState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.springframework.core.annotation.Order;

/** Stream topic about recoveries: their changes. */
final class RecoveryStreamTopic {
    private static final StreamTopicRate.Newest FOUR_A_SECOND = new StreamTopicRate.Newest(4);
    private static final String AUDIENCE = "its owner, and in the organisation whoever sees all of its drones";

    private RecoveryStreamTopic() {}

    @JsonTypeName("recovery")
    @Order(650)
    @Schema(
            name = "StreamRecoveryChanged",
            description =
                    "Drones that come home, or down, together; all that are under way once after hello, then when one"
                            + " changes.")
    record RecoveryChanged(RecoveryView recovery) implements StreamMessage.OfUseCase {}

    static StreamTopic<Snapshot<RecoveryState>> of(RecoveryService recoveries) {
        return new StreamTopic<>(
                RecoveryChanged.class,
                FOUR_A_SECOND,
                new StreamTopic.SubjectMapping<>(
                        "recovery", recovery -> recovery.saved().id().value()),
                StreamTopic.Audience.of(AUDIENCE, RecoveryService::isShownTo),
                (recovery, who) -> new RecoveryChanged(recoveries.view(recovery)),
                recoveries::underWay,
                null,
                feed -> recoveries.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> recoveries.picture(operation))));
    }
}
