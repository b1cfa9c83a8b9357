package org.dronemap.ws.command;

import org.dronemap.core.command.CommandRecord;
import org.dronemap.ws.stream.StreamOperation;
import org.dronemap.ws.stream.StreamTopic;
import org.dronemap.ws.stream.delivery.StreamEventRouter;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;
import org.springframework.core.annotation.Order;

/** Spring configuration of the handlers and services for commands. */
@Configuration(proxyBeanMethods = false)
@Import({BroadcastController.class, CommandController.class, BroadcastService.class, CommandService.class})
class CommandConfiguration {
    @Bean
    @Order(70)
    StreamTopic<CommandRecord> commandStreamTopic(StreamEventRouter news) {
        return CommandStreamTopic.of(news);
    }

    @Bean
    @Order(10)
    StreamOperation<CommandStreamOperation.GiveCommand> commandStreamOperation(CommandService commands) {
        return CommandStreamOperation.of(commands);
    }
}
