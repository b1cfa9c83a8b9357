package org.dronemap.ws.parameter;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for parameters of drones. */
@Configuration(proxyBeanMethods = false)
@Import({ParameterController.class, ParameterService.class})
class ParameterConfiguration {}
