package org.dronemap.ws.wiring;

import java.net.InetAddress;
import java.net.UnknownHostException;
import org.apache.catalina.connector.Connector;
import org.dronemap.ws.environment.SetupException;
import org.dronemap.ws.limit.BoundedHttpProtocol;
import org.dronemap.ws.limit.ClientLimits;
import org.dronemap.ws.plainhttp.OriginalAddressFilter;
import org.dronemap.ws.security.ProblemWriter;
import org.dronemap.ws.settings.ServerSettings;
import org.springframework.boot.tomcat.servlet.TomcatServletWebServerFactory;
import org.springframework.boot.web.server.WebServerFactoryCustomizer;
import org.springframework.boot.web.servlet.FilterRegistrationBean;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.core.Ordered;

/** Spring configuration that opens the ports of the original Dronemap Planner if the settings ask for them. */
@Configuration(proxyBeanMethods = false)
class OriginalAddressConfiguration {
    @Bean
    WebServerFactoryCustomizer<TomcatServletWebServerFactory> originalPorts(ServerSettings settings) {
        return factory -> {
            if (settings.originalAddresses()) {
                OriginalAddressFilter.ports()
                        .forEach(port -> factory.addAdditionalConnectors(connector(port, settings)));
            }
        };
    }

    /** With the bounds of the server's own port. */
    private static Connector connector(int port, ServerSettings settings) {
        ClientLimits limits = settings.protection().clients();
        BoundedHttpProtocol protocol = new BoundedHttpProtocol();
        protocol.limits(limits);
        protocol.setConnectionTimeout((int) limits.patience().toMillis());
        try {
            protocol.setAddress(InetAddress.getByName(settings.bindAddress()));
        } catch (UnknownHostException e) {
            throw new SetupException("DRONEMAP_BIND: there is no address " + settings.bindAddress() + ".", e);
        }
        Connector connector = new Connector(protocol);
        connector.setPort(port);
        connector.setXpoweredBy(false);
        return connector;
    }

    /** The first: all others see the address that is meant. */
    @Bean
    FilterRegistrationBean<OriginalAddressFilter> originalAddresses(ProblemWriter problems, ServerSettings settings) {
        FilterRegistrationBean<OriginalAddressFilter> registration =
                new FilterRegistrationBean<>(new OriginalAddressFilter(problems));
        registration.setEnabled(settings.originalAddresses());
        registration.setOrder(Ordered.HIGHEST_PRECEDENCE);
        registration.addUrlPatterns("/*");
        return registration;
    }
}
