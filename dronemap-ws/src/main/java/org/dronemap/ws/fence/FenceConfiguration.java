package org.dronemap.ws.fence;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for fences. */
@Configuration(proxyBeanMethods = false)
@Import({FenceController.class, FenceService.class})
class FenceConfiguration {}
