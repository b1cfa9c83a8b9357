package org.dronemap.ws.robotkey;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for keys of robots. */
@Configuration(proxyBeanMethods = false)
@Import({RobotKeyController.class, RobotKeyService.class, RobotKeyService.Dependencies.class})
class RobotKeyConfiguration {}
