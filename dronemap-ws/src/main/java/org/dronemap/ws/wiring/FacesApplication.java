package org.dronemap.ws.wiring;

import org.dronemap.ws.server.House;
import org.dronemap.ws.settings.Settings;
import org.springframework.boot.SpringBootConfiguration;
import org.springframework.boot.autoconfigure.EnableAutoConfiguration;
import org.springframework.context.annotation.ComponentScan;
import org.springframework.context.annotation.Configuration;

/**
 * The web server with all faces: whatever a {@code @Configuration} of this package constructs. Wants a {@link House} and
 * {@link Settings} in its context.
 */
@SpringBootConfiguration(proxyBeanMethods = false)
@EnableAutoConfiguration
@ComponentScan(useDefaultFilters = false, includeFilters = @ComponentScan.Filter(Configuration.class))
public class FacesApplication {}
