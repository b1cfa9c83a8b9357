package org.dronemap.ws.audit;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for audit records. */
@Configuration(proxyBeanMethods = false)
@Import({AuditController.class, AuditService.class})
class AuditConfiguration {}
