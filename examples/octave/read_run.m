% Reads response.h5 of a run folder in Octave and in MATLAB: draws the loop and says the peak force.
file = 'run/response.h5';
if exist('OCTAVE_VERSION', 'builtin')
  load('-hdf5', file, 'response');             % a structure of all signals
else
  for name = {'time', 'displacement_x', 'force_x', 'impact_x', 'gap'}
    response.(name{1}) = h5read(file, ['/response/' name{1}]);
  end
end
impact = abs(response.impact_x(:));
[peak, at] = max(impact);
text = sprintf('%d instants, rim force up to %.1f kN at %.4f s, penetration %.3f mm', numel(impact), peak / 1e3, response.time(at), ...
                  -1e3 * min(response.gap(:)));
disp(text)
if ~exist('OCTAVE_VERSION', 'builtin') || ~isempty(available_graphics_toolkits())
  plot(1e3 * response.displacement_x(:), -response.force_x(:) / 1e3), grid on
  xlabel('displacement [mm]'), ylabel('lateral force [kN]')
  print('-dpng', '-r90', 'picture.png')
end
