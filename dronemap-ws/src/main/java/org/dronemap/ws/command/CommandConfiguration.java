package org.dronemap.ws.command;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for commands. */
@Configuration(proxyBeanMethods = false)
@Import({BroadcastController.class, CommandController.class, BroadcastService.class, CommandService.class})
class CommandConfiguration {}
