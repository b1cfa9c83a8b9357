package org.dronemap.ws.command;

import com.fasterxml.jackson.annotation.JsonTypeName;
import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.ws.stream.StreamMessage;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.StreamTopicRate;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.core.annotation.Order;

/** Defines the topic of the WebSocket stream about commands. */
final class CommandStreamTopic {
    private CommandStreamTopic() {}

    @JsonTypeName("command")
    @Order(700)
    @Schema(name = "StreamCommand", description = "A command whose phase has changed.")
    record CommandChanged(CommandView command) implements StreamMessage.OfUseCase {}

    static StreamTopic<CommandRecord> of(StreamEventRouter news) {
        return new StreamTopic<>(
                CommandChanged.class,
                new StreamTopicRate.EveryChange(),
                StreamTopic.SubjectMapping.ofDrone(CommandRecord::drone),
                StreamTopic.Audience.of("whoever sees the drone", (who, command) -> who.sees(command.drone())),
                (command, who) -> new CommandChanged(CommandView.of(command)),
                List::of,
                null,
                feed -> news.onCommand(feed::publish));
    }
}
