package org.dronemap.ws.zone;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for zones. */
@Configuration(proxyBeanMethods = false)
@Import({ZoneController.class, ZoneService.class, ZoneService.Stores.class})
class ZoneConfiguration {}
