package org.dronemap.ws.control;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for control and steering. */
@Configuration(proxyBeanMethods = false)
@Import({ControlController.class, ControlService.class, SteeringService.class})
class ControlConfiguration {}
