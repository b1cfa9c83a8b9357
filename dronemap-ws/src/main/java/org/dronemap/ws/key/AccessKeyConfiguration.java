package org.dronemap.ws.key;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for access keys. */
@Configuration(proxyBeanMethods = false)
@Import({AccessKeyController.class, AccessKeyService.class})
class AccessKeyConfiguration {}
