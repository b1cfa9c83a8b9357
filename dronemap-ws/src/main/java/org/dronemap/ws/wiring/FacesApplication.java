package org.dronemap.ws.wiring;

import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.settings.ServerSettings;
import org.springframework.boot.SpringBootConfiguration;
import org.springframework.boot.autoconfigure.EnableAutoConfiguration;
import org.springframework.context.annotation.ComponentScan;
import org.springframework.context.annotation.Configuration;

/**
 * Spring Boot application of the web server with all faces, made from the configurations of this package and of
 * all rooms. Wants a {@link ServerComponents} and {@link ServerSettings} in its context.
 */
@SpringBootConfiguration(proxyBeanMethods = false)
@EnableAutoConfiguration
@ComponentScan(
        basePackages = "org.dronemap.ws",
        resourcePattern = "**/*Configuration.class",
        useDefaultFilters = false,
        includeFilters = @ComponentScan.Filter(Configuration.class))
public class FacesApplication {}
