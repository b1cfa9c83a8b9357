package org.dronemap.ws.wiring;

import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.ServerSettings;
import org.springframework.boot.SpringBootConfiguration;
import org.springframework.boot.autoconfigure.EnableAutoConfiguration;
import org.springframework.context.annotation.ComponentScan;
import org.springframework.context.annotation.Configuration;

/**
 * The web server with all faces: whatever a {@code @Configuration} of this package constructs. Wants a {@link ServerComponents} and
 * {@link ServerSettings} in its context.
 */
@SpringBootConfiguration(proxyBeanMethods = false)
@EnableAutoConfiguration
@ComponentScan(useDefaultFilters = false, includeFilters = @ComponentScan.Filter(Configuration.class))
public class FacesApplication {}
