package org.dronemap.ws.mission;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for missions. */
@Configuration(proxyBeanMethods = false)
@Import({MissionController.class, MissionService.class})
class MissionConfiguration {}
