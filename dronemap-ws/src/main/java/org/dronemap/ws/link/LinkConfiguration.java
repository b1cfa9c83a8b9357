package org.dronemap.ws.link;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for endpoints and the security of links. */
@Configuration(proxyBeanMethods = false)
@Import({
    EndpointController.class,
    LinkSecurityController.class,
    EndpointService.class,
    DtlsKeyService.class,
    LinkSecurityService.class
})
class LinkConfiguration {}
