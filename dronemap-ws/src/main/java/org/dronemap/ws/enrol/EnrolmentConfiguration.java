package org.dronemap.ws.enrol;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for vehicles that wait to be enrolled. */
@Configuration(proxyBeanMethods = false)
@Import({EnrolmentController.class, EnrolmentService.class})
class EnrolmentConfiguration {}
