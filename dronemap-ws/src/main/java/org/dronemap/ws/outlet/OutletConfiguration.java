package org.dronemap.ws.outlet;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for the outlet. */
@Configuration(proxyBeanMethods = false)
@Import({OutletController.class, OutletService.class})
class OutletConfiguration {}
