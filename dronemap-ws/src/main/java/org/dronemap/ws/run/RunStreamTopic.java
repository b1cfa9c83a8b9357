package org.dronemap.ws.run;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import org.dronemap.cognitive.operation.run.RunState;
import org.dronemap.core.conduct.Operations.Snapshot;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about mission runs. */
final class RunStreamTopic {
    private RunStreamTopic() {}

    @JsonTypeName("run")
    @Order(500)
    @Schema(
            name = "StreamRunChanged",
            description = "A mission run; all that are under way once after hello, then while it changes.")
    record RunChanged(RunView run) implements StreamMessage.OfUseCase {}

    static StreamTopic<Snapshot<RunState>> of(RunService runs) {
        return new StreamTopic<>(
                RunChanged.class,
                new StreamTopicRate.Newest(4),
                new StreamTopic.SubjectMapping<>("run", run -> run.saved().id().value()),
                StreamTopic.Audience.of("the organisation, whoever sees all drones of the run", RunService::isShownTo),
                (run, who) -> new RunChanged(RunViewMapper.view(run)),
                runs::underWay,
                null,
                feed -> runs.addListener(
                        (operation, why) -> feed.changed(operation.id().value(), () -> runs.picture(operation))));
    }
}
